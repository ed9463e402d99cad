#pragma once

#include <Eigen/Core>

#include <cmath>

namespace espalier {

/// The place that a scanner at the origin measures: how far it is, and into which direction.
/// @param range     [L]
/// @param azimuth   [rad], counted from x to y
/// @param elevation [rad], from the plane of these to z
/// Source: C. Preuksakarn, thesis, 2012, eq. 1.4, which counts from z down: pi / 2 - elevation.
[[nodiscard]] inline Eigen::Vector3d fromSpherical(double range, double azimuth, double elevation) {
  return {range * std::cos(elevation) * std::cos(azimuth),
          range * std::cos(elevation) * std::sin(azimuth), range * std::sin(elevation)};
}

} // namespace espalier
