#pragma once

#include "core/base/progress.h"

#include <Eigen/Core>

namespace espalier {

/// Contracts a cloud: each point moves to the mean of the points within `radius` [L] of it in
/// space. Fast, and as good as the geodesic one where twigs keep farther apart than the radius;
/// nearer ones pull each other.
///
/// @param points 3 x N, finite [L]
/// @return 3 x N, the new place of each point [L]
/// @throws Cancelled if `progress` asks to stop
/// Deterministic; on all threads. Time O(N (log N + s)) for s parts at the surface of a ball.
/// Source: PlantScan3D's Euclidean contraction.
[[nodiscard]] Eigen::Matrix3Xf contractedToBallMeans(const Eigen::Matrix3Xf& points, double radius,
                                                     const Progress& progress = {});

} // namespace espalier
