#pragma once

#include "core/skeleton/axes.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

/// What a reviewer looks at in one go: neighboring nodes of one axis, from the root outward.
using Stretch = std::vector<NodeId>; // not empty

/// The axes in the order in which one walks along them: the trunk, then each axis that is attached
/// to it, from its foot to its tip, followed by what that carries. So a branch is done, twigs and
/// all, before the next begins. O(N).
[[nodiscard]] std::vector<Axis> axesInWalkOrder(const Skeleton& skeleton);

/// The stretches of all axes in that order: each node is in one. A stretch ends at a node with
/// several children, at an apex, and before it gets longer than `longest`. O(N).
/// @param longest  along the axis [L]; only an edge that alone is longer makes a longer stretch
[[nodiscard]] std::vector<Stretch> stretches(const Skeleton& skeleton, double longest);

/// What fits a screen together with its surroundings: a tenth of the diagonal of the plant [L].
[[nodiscard]] double longestStretch(const Skeleton& skeleton);

/// Whether nodes are no more than one looks at in one go: all of one axis, or together no longer
/// than two of the longest stretches. Each node counts with the edge to its parent. O(nodes).
[[nodiscard]] bool isOneLook(const Skeleton& skeleton, const std::vector<NodeId>& nodes);

/// The stretch that `id` is in; none: the node is gone. O(N).
[[nodiscard]] std::optional<std::size_t> stretchOf(const std::vector<Stretch>& stretches,
                                                   NodeId id);

enum class WalkTo : std::uint8_t {
  anyStretch,
  toDo,        // in part at least
  notReviewed, // likewise: to do or doubtful
  openEnd,     // an apex that is not reviewed
  branching    // a node with several children that is not reviewed
};
enum class WalkDirection : std::uint8_t { forward, backward };

/// The next stretch of this kind after `from`, and from the other end on once the walk is through;
/// `from` itself comes last. None: there is none of the kind. O(N).
/// @param from  none: before the first, or behind the last if the direction is backward
[[nodiscard]] std::optional<std::size_t> walk(const Skeleton& skeleton,
                                              const std::vector<Stretch>& stretches,
                                              std::optional<std::size_t> from, WalkTo to,
                                              WalkDirection direction = WalkDirection::forward);

} // namespace espalier
