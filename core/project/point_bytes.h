#pragma once

#include "core/cloud/point_cloud.h"

#include <string>
#include <string_view>

namespace espalier {

/// A cloud as bytes of a project, about 23 for a point: the size of each part, then the parts;
/// stations, where there are any, come last, with 2 for a point.
/// Numbers are little-endian. Project::setBytes guards them against damage.
[[nodiscard]] std::string bytesOf(const PointCloud& cloud);
/// @throws Error if the bytes are none of a cloud
[[nodiscard]] PointCloud cloudFrom(std::string_view bytes);

/// Positions alone, as contraction yields.
[[nodiscard]] std::string bytesOf(const Eigen::Matrix3Xf& positions);
/// @throws Error if the bytes are none of positions, or one is not finite
[[nodiscard]] Eigen::Matrix3Xf positionsFrom(std::string_view bytes);

} // namespace espalier
