#pragma once

#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier {

/// How near nodes must lie to be taken for the same, from how far nodes are apart [L]: a quarter of
/// the mean length of an edge. 0 without edges of some length.
[[nodiscard]] double duplicateTolerance(const Skeleton& skeleton);

/// Nodes that lie within `tolerance` [L] of another one that is neither their parent nor their
/// child, in the order of Skeleton::ids(). Time O(n log n) unless many lie in one place.
[[nodiscard]] std::vector<NodeId> duplicatedNodes(const Skeleton& skeleton, double tolerance);

/// The nodes of branches that follow another axis all along, nowhere farther from it than
/// `tolerance` [L]: of two that follow each other, the shorter one. Axes shorter than twice the
/// tolerance count as none. Distances are measured to samples a half of the tolerance apart, so
/// some up to 3 % below it may be missed. Time O(n log n) for nodes and samples.
[[nodiscard]] std::vector<NodeId> duplicatedBranches(const Skeleton& skeleton, double tolerance);

} // namespace espalier
