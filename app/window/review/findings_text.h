#pragma once

#include "core/skeleton/finding.h"

#include <map>
#include <string>
#include <vector>

namespace espalier {

/// Findings that are ignored, as a project keeps them: [{"kind": "sharp_turn", "nodes": [12, 13]},
/// {"kind": "unexplained_points", "nodes": [4], "place": [x, y, z], "reach": 0.2}]. Empty: none.
[[nodiscard]] std::string textOf(const std::vector<Finding>& findings);

/// Of an empty text, none.
/// @throws Error if it is no such text
[[nodiscard]] std::vector<Finding> findingsFrom(const std::string& text);

/// Limits of the checks that were set, as a project keeps them: {"sharp_turn": 60}. Empty: none.
[[nodiscard]] std::string textOf(const std::map<std::string, double>& limits);

/// Of an empty text, none.
/// @throws Error if it is no such text
[[nodiscard]] std::map<std::string, double> limitsFrom(const std::string& text);

} // namespace espalier
