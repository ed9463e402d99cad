#pragma once

#include "core/mtg/mtg_parser.h"

#include <optional>
#include <string>
#include <vector>

namespace espalier {

/// The text of a file with more features: a line for each at the end of its section FEATURES, and a
/// column behind the others. All else stays as it was, comments too.
///
/// @param added none of those of the file
/// @return none if the file has no such section, or no column of a feature: codes would stand where
/// the new columns begin
/// Time O(sections).
[[nodiscard]] std::optional<std::string> withMoreFeatures(const ParsedMtg& file,
                                                          const std::vector<MtgFeature>& added);

} // namespace espalier
