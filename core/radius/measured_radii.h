#pragma once

#include "core/base/progress.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// Mean distance from the points around each node to the skeleton [L], by id; 0 where no point is
/// nearest to the node.
///
/// @param points 3 x N [L], in the frame of the skeleton after adding `origin`
/// Time O(N log n).
[[nodiscard]] std::vector<double> meanPointDistances(const Skeleton& skeleton,
                                                     const Eigen::Matrix3Xf& points,
                                                     const Eigen::Vector3d& origin,
                                                     const Progress& progress = {});

} // namespace espalier
