#pragma once

#include "core/base/progress.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

namespace espalier {

/// `skeleton` with the foot of thick wood on its axis.
///
/// A root that was found on the bark lies beside the axis, so that the first edges lead across the
/// wood. Where they turn by more than 25 degrees within 2 radii, and by more than a third of one
/// across, the nodes there come to lie on the line on which the wood goes on, drawn backwards to
/// where the points around it end, by 2 radii at most. What then lies within the wood beside that
/// line is removed. The radius is here the median distance of points to the axis near the root. A
/// root that bears branches out of the wood stays.
///
/// @param points 3 x N [L], in the frame of the skeleton after adding `origin`
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N log n).
[[nodiscard]] Skeleton withFootOnAxis(const Skeleton& skeleton, const Eigen::Matrix3Xf& points,
                                      const Eigen::Vector3d& origin, const Progress& progress = {});

} // namespace espalier
