#pragma once

#include "core/base/box_tree.h"
#include "core/evaluate/match/segments.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace espalier {

/// By segment or landmark of one skeleton: that of the other with which it is matched, if any.
using Partners = std::vector<std::optional<std::size_t>>;

[[nodiscard]] Partners inverse(const Partners& partners, std::size_t others);

/// By segment of the result: whether it is matched, and the nearest matched segments below it and
/// below its partner are matched with each other, or there are none below either.
///
/// pre: partners has an entry per segment of the result, each below referenceSegments.size()
/// Time and memory O(segments).
[[nodiscard]] std::vector<bool> conserved(const std::vector<Segment>& resultSegments,
                                          const std::vector<Segment>& referenceSegments,
                                          const Partners& partners);

[[nodiscard]] BoxTree boxTree(const std::vector<Segment>& segments);

[[nodiscard]] double totalLength(const std::vector<Segment>& segments); // [L]

} // namespace espalier
