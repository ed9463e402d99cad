#include "core/contract/circle_center.h"

#include "core/base/circle_fit.h"

#include <Eigen/Geometry>

namespace espalier {

std::optional<WoodCircle> circleAround(const std::vector<Eigen::Vector3f>& points,
                                       const Eigen::Vector3d& direction, double largestRadius) {
  constexpr std::size_t fewest = 6;
  constexpr double leastCoverage = 5.0 / 16;
  constexpr double fullCoverage = 13.0 / 16;
  constexpr double largestError = 0.25; // in radii
  if (points.size() < fewest) return std::nullopt;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& point : points)
    mean += point.cast<double>() / static_cast<double>(points.size());
  const Eigen::Vector3d right = direction.unitOrthogonal();
  const Eigen::Vector3d up = direction.cross(right);
  std::vector<Eigen::Vector2d> section;
  section.reserve(points.size());
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3d d = point.cast<double>() - mean;
    section.emplace_back(d.dot(right), d.dot(up));
  }
  const std::optional<FittedCircle> circle = fitCircle(section);
  if (!circle || circle->radius > largestRadius) return std::nullopt;
  if (circle->coverage < leastCoverage || circle->coverage > fullCoverage) return std::nullopt;
  if (circle->error > largestError * circle->radius) return std::nullopt;
  return WoodCircle{.center = mean + circle->center.x() * right + circle->center.y() * up,
                    .normal = direction,
                    .radius = circle->radius};
}

std::optional<Eigen::Vector3d> circleCenter(const std::vector<Eigen::Vector3f>& points,
                                            const Eigen::Vector3d& direction,
                                            double largestRadius) {
  const std::optional<WoodCircle> circle = circleAround(points, direction, largestRadius);
  if (!circle) return std::nullopt;
  return circle->center;
}

} // namespace espalier
