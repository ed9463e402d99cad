#pragma once

#include "core/evaluate/differences/differences.h"
#include "core/evaluate/match/edit_comparison.h"

#include <map>
#include <string>
#include <vector>

namespace espalier {

/// How a plant is compared with its reference, as a project keeps it.
struct EvaluationText {
  double tolerance = 0;                    // [L]; 0: as the reference suggests
  bool isLaid = true;                      // the reference on the plant
  bool turns = true;                       // turned, too
  EditOptions edit = {};                   // but the weights
  std::vector<DifferingPart> ignored = {}; // kind and `at` alone
  /// Of references before, by their keys.
  std::map<std::string, std::vector<DifferingPart>> ignoredOf = {};
  bool operator==(const EvaluationText&) const = default;
};

/// As JSON: {"tolerance": 10, "laid": false, "turned": true, "edit_unit": "segment", "edit_cost":
/// "topology", "merge_paths": false, "ignored": [{"kind": "missed", "at": [x, y, z]}],
/// "ignored_of": {"/expert.mtg": [as before]}}; empty if all is as at first. What is missing is as
/// at first, too.
[[nodiscard]] std::string textOf(const EvaluationText& evaluation);

/// @throws Error if it is no such text
[[nodiscard]] EvaluationText evaluationFrom(const std::string& text);

} // namespace espalier
