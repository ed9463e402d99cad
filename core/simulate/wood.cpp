#include "core/simulate/wood.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace espalier {
namespace {

/// How a frustum stands.
struct Stance {
  explicit Stance(const Frustum& frustum)
      : axis(frustum.to - frustum.from), height(axis.norm()),
        slope(height > 0 ? (frustum.toRadius - frustum.fromRadius) / height : 0) {
    if (height > 0) axis /= height;
  }
  Eigen::Vector3d axis; // unit
  double height;        // [L]
  double slope;         // of the radius along the axis
};

/// The normal of the frustum at a place on its surface, `across` from its axis.
Eigen::Vector3d normalAt(const Stance& stance, const Eigen::Vector3d& across) {
  return (across.normalized() - stance.slope * stance.axis).normalized();
}

std::optional<WoodHit> hitFrustum(const EdgeSolid& solid, const Ray& ray) {
  const Stance stance(solid);
  if (stance.height == 0) return std::nullopt;
  // Solved about the place on the ray nearest to the solid: far scanners would lose thin twigs in
  // the rounding of squared distances.
  const double shift = (solid.from - ray.origin).dot(ray.direction);
  const Eigen::Vector3d start = ray.origin + shift * ray.direction - solid.from;
  const double along = ray.direction.dot(stance.axis);
  const double startAlong = start.dot(stance.axis);
  const double startRadius = solid.fromRadius + stance.slope * startAlong;
  // |across|^2 = radius^2 at start + t direction:  a t^2 + 2 b t + c = 0
  const double a = 1 - along * along * (1 + stance.slope * stance.slope);
  const double b = start.dot(ray.direction) - along * (startAlong + stance.slope * startRadius);
  const double c = start.squaredNorm() - startAlong * startAlong - startRadius * startRadius;
  const double discriminant = b * b - a * c;
  if (discriminant < 0 || std::abs(a) < 1e-14) return std::nullopt;
  const double root = std::sqrt(discriminant);
  std::optional<WoodHit> result;
  for (const double t : {(-b - root) / a, (-b + root) / a}) {
    const double height = startAlong + t * along;
    const double range = t + shift;
    if (height < 0 || height > stance.height || !(range > 0)) continue;
    if (result && result->range <= range) continue;
    const Eigen::Vector3d across = start + t * ray.direction - height * stance.axis;
    const Eigen::Vector3d normal = normalAt(stance, across);
    if (normal.dot(ray.direction) < 0) result = WoodHit{range, normal, solid.node, solid.organ};
  }
  return result;
}

std::optional<WoodHit> hitBall(const EdgeSolid& solid, const Ray& ray) {
  const double nearest = (solid.to - ray.origin).dot(ray.direction);
  const Eigen::Vector3d across = ray.origin + nearest * ray.direction - solid.to;
  const double inside = solid.toRadius * solid.toRadius - across.squaredNorm();
  if (inside < 0) return std::nullopt;
  const double depth = std::sqrt(inside);
  const double range = nearest - depth;
  if (!(range > 0)) return std::nullopt;
  return WoodHit{range, (across - depth * ray.direction).normalized(), solid.node, solid.organ};
}

[[noreturn]] void refuse(NodeId id, const char* what) {
  throw Error(nameOf(id) + ": " + what);
}

} // namespace

std::vector<EdgeSolid> woodOf(const Skeleton& plant) {
  std::vector<EdgeSolid> wood;
  for (const NodeId id : plant.ids()) {
    const Node& node = plant[id];
    if (!node.position.allFinite()) refuse(id, "its position is not finite; move or delete it");
    if (!node.parent) continue;
    if (!(node.radius > 0) || !std::isfinite(node.radius))
      refuse(id, "it has no radius; give the plant radii first");
    wood.push_back({*frustumOf(plant, id), id, Organ::wood});
  }
  return wood;
}

std::optional<WoodHit> hit(const EdgeSolid& solid, const Ray& ray) {
  std::optional<WoodHit> side = hitFrustum(solid, ray);
  std::optional<WoodHit> ball = hitBall(solid, ray);
  if (!side) return ball;
  if (!ball) return side;
  return side->range <= ball->range ? side : ball;
}

double signedDistance(const EdgeSolid& solid, const Eigen::Vector3d& place) {
  const double ball = (place - solid.to).norm() - solid.toRadius;
  const Stance stance(solid);
  if (stance.height == 0) return ball;
  const Eigen::Vector3d start = place - solid.from;
  const double along = start.dot(stance.axis);
  const double across = (start - along * stance.axis).norm();
  // In the half plane through the axis: the frustum is a trapezoid under its slanted side.
  const double lean = std::sqrt(1 + stance.slope * stance.slope);
  const double above = (across - solid.fromRadius - stance.slope * along) / lean;
  const double foot = (along + stance.slope * (across - solid.fromRadius)) / lean; // on the side
  const double side = stance.height * lean;
  const double beyond = foot < 0 ? foot : std::max(0.0, foot - side);
  if (above <= 0 && along >= 0 && along <= stance.height) return std::min(above, ball);
  if (above <= 0) return std::min(ball, std::max(-along, along - stance.height));
  return std::min(ball, std::hypot(above, beyond));
}

} // namespace espalier
