#pragma once

#include "core/skeleton/skeleton.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace espalier {

/// An unbranched end of a plant: from a branching up to a tip.
struct BranchEnd {
  NodeId foot;               // the branching node that bears it
  std::vector<NodeId> nodes; // from the tip down, without the foot; never empty
  double length = 0;         // [L] from the foot to the tip
};

/// Nodes without children. Time O(n).
[[nodiscard]] std::size_t tipCount(const Skeleton& skeleton);

/// The end with a tip; none if the plant is unbranched from the tip down to its root.
/// pre: `tip` has no children. Time O(its nodes).
[[nodiscard]] std::optional<BranchEnd> branchEndAt(const Skeleton& skeleton, NodeId tip);

/// All of them, by the order of their tips in skeleton.ids(). Time O(n).
[[nodiscard]] std::vector<BranchEnd> branchEnds(const Skeleton& skeleton);

} // namespace espalier
