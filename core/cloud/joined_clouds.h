#pragma once

#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"

#include <Eigen/Geometry>

#include <memory>
#include <string>
#include <vector>

namespace espalier {

/// A cloud, and where it lies in a frame that several share.
struct PlacedCloud {
  std::shared_ptr<const PointCloud> cloud;                  // not null
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity(); // into the common frame
  std::string name; // of the station of its points, if it knows of none
};

/// All points of several clouds in their common frame, as one cloud.
///
/// It lists the points of the first cloud in the order of its file, then those of the next. Colors
/// and intensities are kept if all clouds have them. Stations are kept, and scanners moved with
/// their points; the points of a cloud without stations are of one that has its name.
/// @throws Error     if there are over 65536 stations, or over 2^32 - 1 points
/// @throws Cancelled if `progress` asks to stop
/// Time O(N log N); memory 24 bytes a point beside the result.
[[nodiscard]] PointCloud joined(const std::vector<PlacedCloud>& clouds,
                                const Progress& progress = {});

} // namespace espalier
