#pragma once

#include "core/base/progress.h"

#include <Eigen/Core>

namespace espalier {

enum class UpAxis { x, y, z };

/// A point at the foot of the plant: of the patches of linked points within the lowest 2 % of the
/// height, the one with most points is the foot; of it, the point nearest to its mean.
///
/// Stray points below the plant and single twigs that reach low do not deceive it.
/// @param points 3 x N [L], N > 0
/// @return a column of `points`
/// Time O(N log N).
[[nodiscard]] Eigen::Index findRoot(const Eigen::Matrix3Xf& points, UpAxis up = UpAxis::z,
                                    const Progress& progress = {});

/// The point nearest to `place` [L], in the frame of `points`. pre: N > 0
[[nodiscard]] Eigen::Index nearestPoint(const Eigen::Matrix3Xf& points,
                                        const Eigen::Vector3f& place);

} // namespace espalier
