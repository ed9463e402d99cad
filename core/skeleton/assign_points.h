#pragma once

#include "core/base/progress.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// Where a point of a cloud lies along a skeleton.
struct PointOnSkeleton {
  NodeId child;    // upper end of the nearest edge; a root that has no edge stands for itself
  double fraction; // along the edge, 0 at the parent, 1 at the child
  double distance; // from the point to the edge [L]
};

/// The nearest edge for each point.
///
/// @param points 3 x N [L], in the frame of the skeleton after adding `origin`
/// pre: the skeleton is not empty
/// Uses all threads. Time O(N log n).
[[nodiscard]] std::vector<PointOnSkeleton> assignPoints(const Eigen::Matrix3Xf& points,
                                                        const Eigen::Vector3d& origin,
                                                        const Skeleton& skeleton,
                                                        const Progress& progress = {});

} // namespace espalier
