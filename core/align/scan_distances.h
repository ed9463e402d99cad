#pragma once

#include "core/base/progress.h"
#include "core/base/spatial_index.h"
#include "core/cloud/point_cloud.h"

#include <Eigen/Geometry>

#include <vector>

namespace espalier {

/// How far each point of a scan that was moved is from the nearest one of the scan that stays [L],
/// in the order of its columns.
/// @param index of the positions of `fixed`; the points that it passes over do not count
/// @param motion from the frame of `moved` to that of `fixed`
/// @throws Cancelled if `progress` asks to stop
/// On all threads. Time O(N log M).
[[nodiscard]] std::vector<float> distancesToScan(const PointCloud& moved,
                                                 const Eigen::Isometry3d& motion,
                                                 const PointCloud& fixed, const SpatialIndex& index,
                                                 const Progress& progress = {});

} // namespace espalier
