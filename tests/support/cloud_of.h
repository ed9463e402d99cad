#pragma once

#include "core/cloud/point_cloud.h"

#include <memory>

namespace espalier::test {

/// A scan of these points, moved to `place` in the frame of its file.
[[nodiscard]] inline std::shared_ptr<const PointCloud>
cloudOf(const Eigen::Matrix3Xf& points, const Eigen::Vector3d& place = {500, 600, 700}) {
  RawPoints raw;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    raw.positions.emplace_back(points.col(i).cast<double>() + place);
  return std::make_shared<const PointCloud>(std::move(raw));
}

/// The same as they are.
[[nodiscard]] inline std::shared_ptr<const PointCloud>
cloudAtOrigin(const Eigen::Matrix3Xf& points) {
  return cloudOf(points, Eigen::Vector3d::Zero());
}

} // namespace espalier::test
