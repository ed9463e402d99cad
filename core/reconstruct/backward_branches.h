#pragma once

#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier {

/// How much the branches of each part of a skeleton would point back if the part were entered at
/// each of its nodes.
///
/// Branches of plants leave at acute angles to the direction of growth: of wood that is entered at
/// a wrong end, they point back to that end. At a node, each arm but the one that leads to where
/// the part is entered counts the cosine of the angle between these two, if it is acute. Where the
/// part is entered, each two arms count the cosine of what they lack of going straight on through
/// it, if that is acute: wood does not begin amid a straight axis. Arms are followed over 4 nodes
/// along what has most nodes; an arm of fewer than 4 counts less.
///
/// @param isCut by id: no edge leads to the parent; the parts are what is left connected
/// @return by id, 0 for a part that grows from there without any backward branch
/// Time O(N) for nodes of few children.
[[nodiscard]] std::vector<double> backwardBranches(const Skeleton& skeleton,
                                                   const std::vector<bool>& isCut);

} // namespace espalier
