#pragma once

#include "core/cloud/point_set.h"

#include <Eigen/Core>

#include <optional>

namespace espalier {

/// The middle of the 5 points nearest to a place.
///
/// Looks at every point: for positions that change, and have no index. 1 ms for a million of them.
/// @param points   3 x N about `origin` [L]
/// @param without  columns that do not count
/// @param place    [L], in the frame of `origin`
/// @param reach    [L] only points within this count
/// @return none if no point is within reach
[[nodiscard]] std::optional<Eigen::Vector3d>
middleOfNearest(const Eigen::Matrix3Xf& points, const Eigen::Vector3d& origin,
                const PointSet& without, const Eigen::Vector3d& place, double reach);

} // namespace espalier
