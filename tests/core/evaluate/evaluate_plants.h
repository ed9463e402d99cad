#pragma once

#include "core/skeleton/skeleton.h"

#include <Eigen/Geometry>

namespace espalier::test {

/// `plant` with each position p at place(p), and radii unchanged.
template <class Place> [[nodiscard]] Skeleton placed(Skeleton plant, const Place& place) {
  for (const NodeId id : plant.ids())
    plant.setPosition(id, place(plant[id].position));
  return plant;
}

[[nodiscard]] inline Skeleton shifted(const Skeleton& plant, const Eigen::Vector3d& by) {
  return placed(plant, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d { return p + by; });
}

[[nodiscard]] inline Skeleton scaled(const Skeleton& plant, double factor) {
  return placed(plant, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d { return p * factor; });
}

/// A turn about an oblique axis, then a shift of several meters.
[[nodiscard]] inline Eigen::Isometry3d someMotion() {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  motion.rotate(Eigen::AngleAxisd(1, Eigen::Vector3d(1, -2, 3).normalized()));
  motion.pretranslate(Eigen::Vector3d(5, -7, 11));
  return motion;
}

[[nodiscard]] inline Skeleton moved(const Skeleton& plant, const Eigen::Isometry3d& motion) {
  return placed(plant, [&](const Eigen::Vector3d& p) -> Eigen::Vector3d { return motion * p; });
}

} // namespace espalier::test
