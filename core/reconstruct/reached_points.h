#pragma once

#include "core/base/progress.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

namespace espalier {

/// @throws Error if under half of the points are connected with the root
void requireHalf(Eigen::Index reached, Eigen::Index all);

/// `skeleton` with the mean distance from each node to the points nearest to it as its radius [L];
/// 0 where there are none.
///
/// @param points 3 x N [L], in the frame of the skeleton
/// @throws Cancelled if `progress` asks to stop
/// Deterministic; on all threads. Time O(N log n) for n nodes.
[[nodiscard]] Skeleton withMeanDistances(Skeleton skeleton, const Eigen::Matrix3Xf& points,
                                         const Progress& progress = {});

} // namespace espalier
