#pragma once

#include <string_view>

namespace espalier {

/// Whether a value of a feature stands for none: empty, or NA, None, missing as other programs
/// write.
[[nodiscard]] inline bool isMissingMtgValue(std::string_view value) {
  return value.empty() || value == "NA" || value == "None" || value == "missing";
}

} // namespace espalier
