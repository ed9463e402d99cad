#pragma once

#include "core/skeleton/skeleton.h"

#include <Eigen/Geometry>

#include <optional>

namespace espalier {

/// Where a node comes to lie that slides along its axis to where it is looked for.
///
/// Its path is its edge to the parent and that to the node that continues its axis, up to a
/// twentieth of each from their other ends. Where the axis ends or begins, it may go on straight
/// ahead, by up to 10 lengths of its edge.
/// @param from   where the node lay at first; where it is in the skeleton does not matter [L]
/// @param sight  a line [L]: the place of the path that is nearest to it is taken
/// @return none if the node has no such edge, or its neighbors lie where it does. pre: contains(id)
/// Time O(children).
[[nodiscard]] std::optional<Eigen::Vector3d>
slidAlongAxis(const Skeleton& skeleton, NodeId id, const Eigen::Vector3d& from,
              const Eigen::ParametrizedLine<double, 3>& sight);

} // namespace espalier
