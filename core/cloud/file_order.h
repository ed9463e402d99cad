#pragma once

#include "core/cloud/point_cloud.h"

#include <vector>

namespace espalier {

/// The points of a cloud in the order of the file they came from, each once. Time O(N log N).
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] std::vector<Eigen::Index> pointsInFileOrder(const PointCloud& cloud,
                                                          const Progress& progress = {});

/// The same points, of which each column is now where it stands in its file: sets of points keep
/// their meaning as long as the file lists the same points first. Time O(N log N).
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] PointCloud sortedAsInFile(const PointCloud& cloud, const Progress& progress = {});

/// The same points in the same columns, as if a file had listed them so. Time O(N).
[[nodiscard]] PointCloud listedByColumn(const PointCloud& cloud);

} // namespace espalier
