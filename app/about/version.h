#pragma once

#include <string>

namespace espalier {

/// The version of the program as it was built: "0.1.0", or "0.1.0~20261126.1720.g9204e9d" of a
/// commit before it (cmake/version.cmake). Sorts as Debian's versions do.
[[nodiscard]] std::string programVersion();

} // namespace espalier
