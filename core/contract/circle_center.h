#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace espalier {

/// A circle in space, across the wood.
struct WoodCircle {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); // [L]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero(); // unit, along the wood
  double radius = 0;                                // [L]
};

/// Where the axis of wood is of which the scanner saw one side only: the mean of its points lies up
/// to 0.64 radii off it.
///
/// A circle is fitted to the points as seen along `direction`. It holds if they cover an arc of
/// about 110 to 300 degrees of it (the mean does where they cover more, nothing where they cover
/// less), lie within a quarter of its radius of it, and it is no larger than `largestRadius`.
///
/// @param points     a short piece of wood [L]
/// @param direction  along it, unit
/// @return a circle in the plane through the mean of the points across `direction`
[[nodiscard]] std::optional<WoodCircle> circleAround(const std::vector<Eigen::Vector3f>& points,
                                                     const Eigen::Vector3d& direction,
                                                     double largestRadius);

/// Its center.
[[nodiscard]] std::optional<Eigen::Vector3d>
circleCenter(const std::vector<Eigen::Vector3f>& points, const Eigen::Vector3d& direction,
             double largestRadius);

} // namespace espalier
