#pragma once

#include "core/base/progress.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// A place where points are missing between two parts of a plant.
struct ScanGap {
  Eigen::Vector3f middle; // between the points on its two sides [L]
  double width;           // [L]
};

/// The gaps that part a scan: of the shortest bridges that join all points, those over 8 spacings
/// wide with at least 10 points on either side. Parts of fewer points are strays or lone tips.
///
/// The scan is seen through the means of cubes of 3 spacings, so that a width may be that much off.
///
/// @param points   3 x N, finite [L]
/// @param spacing  of the points [L], > 0
/// @return the narrowest first
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N log N) as joined() (core/graph/components.h).
[[nodiscard]] std::vector<ScanGap> scanGaps(const Eigen::Matrix3Xf& points, double spacing,
                                            const Progress& progress = {});

} // namespace espalier
