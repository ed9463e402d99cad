#pragma once

#include "core/skeleton/axes.h"

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

/// Those of a part of an axis, neighboring nodes.
[[nodiscard]] std::vector<Stretch> stretchesAlong(const Skeleton& skeleton, const Axis& part,
                                                  double longest);

/// What fits a screen together with its surroundings: a tenth of the diagonal of the plant [L].
[[nodiscard]] double longestStretch(const Skeleton& skeleton);

/// How much one looks at in one go: wood of several axes, and across, in the longest stretches.
inline constexpr double longestLook = 2;

/// Whether nodes are no more than one looks at in one go: all of one axis, or together no longer
/// than two of the longest stretches. Each node counts with the edge to its parent. O(nodes).
[[nodiscard]] bool isOneLook(const Skeleton& skeleton, const std::vector<NodeId>& nodes);

} // namespace espalier
