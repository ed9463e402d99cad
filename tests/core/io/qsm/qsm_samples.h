#pragma once

#include <string>

namespace espalier::test {

/// A tree of four cylinders as TreeQSM 2.4 writes it (cylinder_*.txt): 1 from (0, 0, 0) to (0, 0,
/// 2) of radius 0.2, 2 on it to (0, 0, 3) of 0.1; 3 branches off 1 at (0, 0.2, 2), to (0, 1.2, 2)
/// of 0.05, and 4 continues it to (0, 1.7, 2) of 0.04.
[[nodiscard]] std::string treeQsmTable();

/// The same without names, as TreeQSM 2.3 writes it (cyl_data_*.txt).
[[nodiscard]] std::string treeQsmTableWithoutNames();

} // namespace espalier::test
