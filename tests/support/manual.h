#pragma once

#include <string>
#include <vector>

namespace espalier::test {

/// The chapters of the manual as their files have them, in the order in which README.md lists them;
/// itself first.
[[nodiscard]] std::vector<std::string> manualFiles();

/// The text of all of them.
[[nodiscard]] std::string manualText();

} // namespace espalier::test
