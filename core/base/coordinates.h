#pragma once

#include "core/base/shown_message.h"

#include <Eigen/Core>

namespace espalier {

/// The largest coordinate and radius of points and nodes [L]. What is beyond comes from a damaged
/// file: squares of it, or floats, would be infinite.
inline constexpr double largestCoordinate = 1e12;

/// Not so for what is no number.
[[nodiscard]] inline bool isInRange(const Eigen::Vector3d& position, double radius = 0) {
  return (position.array().abs() <= largestCoordinate).all() && radius <= largestCoordinate;
}

/// What is wrong with a node that is not in range.
[[nodiscard]] inline ShownError outOfRange(const FilePlace& where) {
  return ShownError(
      {Shown::tr("its place or radius is beyond 1e12, as of no plant: correct or remove it"),
       {},
       where});
}

} // namespace espalier
