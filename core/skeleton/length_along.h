#pragma once

#include "core/skeleton/skeleton.h"

#include <optional>
#include <vector>

namespace espalier {

[[nodiscard]] double edgeLength(const Skeleton& skeleton, NodeId id); // [L], 0 for a root

/// Length of all wood that each node carries, its own edge not included, by id [L]. Time O(n).
[[nodiscard]] std::vector<double> carriedLengths(const Skeleton& skeleton);

/// A place on the edge from a node to its parent, or a node itself.
struct SkeletonPlace {
  NodeId node;
  double fraction = 1; // 0 at the parent, 1 at the node; of a root it has no meaning
};

/// Where a place is [L]. pre: the skeleton has its node
[[nodiscard]] Eigen::Vector3d positionOf(const Skeleton& skeleton, const SkeletonPlace& place);

/// The length of the path along edges from one place to another [L]; none if they are in different
/// trees. Time O(depth). pre: the skeleton has both nodes
[[nodiscard]] std::optional<double> lengthAlong(const Skeleton& skeleton, const SkeletonPlace& from,
                                                const SkeletonPlace& to);

} // namespace espalier
