#pragma once

#include "core/base/progress.h"
#include "core/radius/measured_radius.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

namespace espalier {

struct CylinderCenteringOptions {
  int rounds = 1;         // >= 0
  double smoothing = 0.2; // as for withSmoothAxes, after each round, in [0, 1]
  double farthest = 1.5;  // a node moves at most this many radii, > 0
  CylinderOptions cylinders{.leastCoverage = 0.4};
};

/// `skeleton` with its nodes moved onto the axes of cylinders that are fitted to the wood about
/// them, across their own axis; nodes without one stay. Then axes are smoothed.
///
/// A cylinder looks along the wood, so it holds where a single section has too few points, and on a
/// third of the way around it finds the middle of wood that is scanned from one side.
///
/// @param points 3 x N [L], in the frame of the skeleton after adding `origin`
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Uses all threads. Cost as cylindersAbout, for each round.
[[nodiscard]] Skeleton recenteredOnCylinders(const Skeleton& skeleton,
                                             const Eigen::Matrix3Xf& points,
                                             const Eigen::Vector3d& origin,
                                             const CylinderCenteringOptions& options,
                                             const Progress& progress = {});

} // namespace espalier
