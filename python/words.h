#pragma once

#include "core/graph/find_root.h"
#include "core/mtg/mtg_of_skeleton.h"
#include "core/simulate/habit.h"

#include <string>
#include <string_view>

namespace espalier::python {

// Words for choices that are no options of methods. Each throws an Error that names those there
// are.

[[nodiscard]] UpAxis upAxisIn(std::string_view word);
[[nodiscard]] std::string nameOf(UpAxis up);
[[nodiscard]] MtgStyle mtgStyleIn(std::string_view word);
[[nodiscard]] Architecture architectureIn(std::string_view word);
/// How many meters the unit "mm", "cm" or "m" is.
[[nodiscard]] double metersIn(std::string_view unit);

} // namespace espalier::python
