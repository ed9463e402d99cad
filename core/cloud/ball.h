#pragma once

#include <Eigen/Core>

namespace espalier {

/// A part of space that is looked at.
struct Ball {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); // [L], frame of the file
  double radius = 0;                                // [L]

  [[nodiscard]] bool contains(const Eigen::Vector3d& place) const {
    return (place - center).squaredNorm() <= radius * radius;
  }
  bool operator==(const Ball&) const = default;
};

} // namespace espalier
