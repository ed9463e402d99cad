#pragma once

#include "core/mtg/mtg.h"

#include <string_view>

namespace espalier {

/// Whether a value of a feature stands for none: empty, or NA, None, missing as other programs
/// write.
[[nodiscard]] inline bool isMissingMtgValue(std::string_view value) {
  return value.empty() || value == "NA" || value == "None" || value == "missing";
}

/// Whether the values of a feature must be numbers.
[[nodiscard]] inline bool isNumberFeature(const MtgFeature& feature) {
  return feature.type == "REAL" || feature.type == "INT";
}

/// Whether a feature names vertices, so that codes can begin with such a name: "(A1)/U1".
[[nodiscard]] inline bool isAliasFeature(const MtgFeature& feature) {
  return feature.name == "Alias";
}

} // namespace espalier
