#pragma once

#include "core/evaluate/differences/differences.h"
#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier {

/// What the reference has in place of a wrong attachment: the edges, by their upper nodes, from
/// where the part is attached down to where the reference attaches it.
/// @param part of `found`; empty unless it is wrongly attached. Time O(nodes of the path).
[[nodiscard]] std::vector<NodeId> referencePath(const Differences& found, const Skeleton& reference,
                                                const DifferingPart& part);

} // namespace espalier
