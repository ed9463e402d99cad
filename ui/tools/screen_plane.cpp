#include "ui/tools/screen_plane.h"

#include <cmath>

namespace espalier {

Eigen::Hyperplane<double, 3> screenPlane(const Eigen::Vector3d& place, const ToolInput& input) {
  return {input.viewDirection.normalized(), place};
}

std::optional<Eigen::Vector3d> meet(const Eigen::Hyperplane<double, 3>& plane,
                                    const ToolInput& input) {
  const double distance = input.ray.intersectionParameter(plane);
  if (!std::isfinite(distance) || distance < 0) return std::nullopt;
  return input.ray.pointAt(distance);
}

bool isDragged(const QPointF& from, const QPointF& to) {
  constexpr double shakyHand = 3; // logical pixels
  return (to - from).manhattanLength() > shakyHand;
}

} // namespace espalier
