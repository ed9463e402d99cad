#pragma once

#include "core/skeleton/skeleton.h"

#include <optional>
#include <vector>

namespace espalier {

/// A maximal chain of successors, from its first node to its apex.
using Axis = std::vector<NodeId>;

/// Number of branching edges from the root to each node, by id; -1 where there is no node. O(N).
[[nodiscard]] std::vector<int> orders(const Skeleton& skeleton);

/// The order of one node. Time O(depth).
[[nodiscard]] int order(const Skeleton& skeleton, NodeId id); // pre: contains(id)

/// The axes of a skeleton; each comes after the one that bears it. Where a node has several
/// successors, the one with the lowest id continues the axis and the others begin their own. O(N).
[[nodiscard]] std::vector<Axis> axes(const Skeleton& skeleton);

/// The node that continues the axis of `id`, if any. pre: contains(id)
[[nodiscard]] std::optional<NodeId> nextOnAxis(const Skeleton& skeleton, NodeId id);

/// The node before this one on its axis, if any. pre: contains(id)
[[nodiscard]] std::optional<NodeId> previousOnAxis(const Skeleton& skeleton, NodeId id);

/// The axis that a node is part of. pre: contains(id). Time O(length of the axis).
[[nodiscard]] Axis axisThrough(const Skeleton& skeleton, NodeId id);

/// By how much an axis turns at a node, from the edge to it to the next one [rad]; 0 where it
/// begins or ends, or an edge has no length. pre: contains(id)
[[nodiscard]] double turnAt(const Skeleton& skeleton, NodeId id);

/// Length of an axis along its nodes [L], with the edge to the node that bears it.
[[nodiscard]] double length(const Skeleton& skeleton, const Axis& axis);

} // namespace espalier
