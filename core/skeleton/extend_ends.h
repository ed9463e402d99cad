#pragma once

#include "core/base/progress.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

namespace espalier {

/// `skeleton` with its tips, and roots of one child, moved outwards along their last edge to where
/// the points beyond them end.
///
/// Contraction pulls the points at an end inwards, and a node stands in the middle of its points:
/// both make ends too short. Of the points nearest to an end, those beyond it count, but for the
/// farthest tenth; an end moves at most as far as its last edge is long.
///
/// @param points 3 x N [L], in the frame of the skeleton after adding `origin`
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N log n).
[[nodiscard]] Skeleton withExtendedEnds(const Skeleton& skeleton, const Eigen::Matrix3Xf& points,
                                        const Eigen::Vector3d& origin,
                                        const Progress& progress = {});

} // namespace espalier
