#pragma once

#include "core/cloud/point_cloud.h"

#include <vector>

namespace espalier {

/// The points of a cloud in the order of the file they came from, each once. Time O(N log N).
[[nodiscard]] std::vector<Eigen::Index> pointsInFileOrder(const PointCloud& cloud);

} // namespace espalier
