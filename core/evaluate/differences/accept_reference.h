#pragma once

#include "core/evaluate/differences/graft.h"
#include "core/skeleton/skeleton_delta.h"

#include <vector>

namespace espalier {

/// Makes one part of a result as the reference has it.
///
/// What was missed is copied, with its radii or as `copied` says, and attached where it belongs: to
/// a node there, or to a new one on an edge. What the reference goes on with above it is attached
/// to the copy, and what led there instead is removed; a missed foot becomes the root of what stood
/// without it. What was invented is removed but for nodes on the reference; what it carries, and
/// what is wrongly attached, goes to where the reference has it, along copies of what was missed on
/// the path there. Edges made get the type that they have there; what else continued the axis then
/// branches. There are no more trees afterwards, unless the reference has more, too.
///
/// @param found     of the result as it was when it was compared: other parts may have been
///                  accepted since, and nodes moved
/// @param reference as it was compared
/// @return nodes of the result to look at
/// @throws Error if the part is no longer there, no more than an edge is invented, or the plant
///               would fall into several trees; nothing has changed then
/// Time O(nodes of both + nodes of the part * depth).
std::vector<NodeId> acceptReference(SkeletonEditor& editor, const Differences& found,
                                    const Skeleton& reference, const DifferingPart& part,
                                    Copied copied = Copied::wood);

} // namespace espalier
