#pragma once

#include "core/evaluate/differences/differences.h"
#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier {

/// What the reference has in place of a wrong attachment: the edges, by their upper nodes, from
/// where the part hangs down to where the reference attaches it.
/// @param part of `found`; empty unless it is wrongly attached. Time O(length of the way).
[[nodiscard]] std::vector<NodeId> referenceWay(const Differences& found, const Skeleton& reference,
                                               const DifferingPart& part);

} // namespace espalier
