#pragma once

#include "core/skeleton/skeleton.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

// Nodes chosen by how the plant is built, from some that are chosen already. pre, of all: the nodes
// given are contained. Each node comes once, and in an order that follows from the input alone.
// Time O(nodes of the skeleton) unless said otherwise.

/// The nodes and all that they carry.
[[nodiscard]] std::vector<NodeId> downstream(const Skeleton& skeleton,
                                             const std::vector<NodeId>& nodes);

/// The nodes and all that carries them, down to the roots.
[[nodiscard]] std::vector<NodeId> upstream(const Skeleton& skeleton,
                                           const std::vector<NodeId>& nodes);

/// The whole axes that the nodes are part of (core/skeleton/axes.h).
[[nodiscard]] std::vector<NodeId> axesThrough(const Skeleton& skeleton,
                                              const std::vector<NodeId>& nodes);

/// All nodes whose order is that of one of the nodes.
[[nodiscard]] std::vector<NodeId> ofSameOrder(const Skeleton& skeleton,
                                              const std::vector<NodeId>& nodes);

/// The whole trees that the nodes are part of.
[[nodiscard]] std::vector<NodeId> treesOf(const Skeleton& skeleton,
                                          const std::vector<NodeId>& nodes);

/// All nodes whose radius is within `share` of the mean of the nodes', in [0, 1].
/// @throws Error if none of the nodes has a radius
[[nodiscard]] std::vector<NodeId> ofSimilarRadius(const Skeleton& skeleton,
                                                  const std::vector<NodeId>& nodes, double share);

/// The nodes, and those that an edge links to one of them.
[[nodiscard]] std::vector<NodeId> grown(const Skeleton& skeleton, const std::vector<NodeId>& nodes);

/// The nodes without those that an edge links to a node outside. A whole tree stays as it is.
[[nodiscard]] std::vector<NodeId> shrunk(const Skeleton& skeleton,
                                         const std::vector<NodeId>& nodes);

/// All other nodes.
[[nodiscard]] std::vector<NodeId> inverted(const Skeleton& skeleton,
                                           const std::vector<NodeId>& nodes);

/// All nodes that are to do or doubtful.
[[nodiscard]] std::vector<NodeId> notReviewed(const Skeleton& skeleton);

/// The path along edges from one node to another, both included. Time O(depth).
/// @throws Error if they belong to different trees
[[nodiscard]] std::vector<NodeId> pathBetween(const Skeleton& skeleton, NodeId from, NodeId to);

/// The path that a choice of nodes stands for: from the first to the last of several; of a single
/// one, its axis. pre: not empty
/// @throws Error if the first and the last belong to different trees
[[nodiscard]] std::vector<NodeId> pathOf(const Skeleton& skeleton,
                                         const std::vector<NodeId>& nodes);

/// Where a step from a node leads.
enum class NodeStep : std::uint8_t { child, parent, nextSibling, previousSibling };

/// The node one step away: the child that continues the axis, else the first one; the parent; or
/// another child of the same parent, from the last on to the first. None: there is none.
/// pre: contains(id)
[[nodiscard]] std::optional<NodeId> stepFrom(const Skeleton& skeleton, NodeId id, NodeStep step);

} // namespace espalier
