#include "core/simulate/wood.h"

#include "core/base/error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace espalier {
namespace {

/// The frustum of a piece about its own axis.
struct Frustum {
  explicit Frustum(const WoodPiece& piece)
      : axis(piece.to - piece.from), height(axis.norm()),
        slope(height > 0 ? (piece.toRadius - piece.fromRadius) / height : 0) {
    if (height > 0) axis /= height;
  }
  Eigen::Vector3d axis; // unit
  double height;        // [L]
  double slope;         // of the radius along the axis
};

/// The normal of the frustum at a place on its surface, `across` from its axis.
Eigen::Vector3d normalAt(const Frustum& frustum, const Eigen::Vector3d& across) {
  return (across.normalized() - frustum.slope * frustum.axis).normalized();
}

std::optional<WoodHit> hitFrustum(const WoodPiece& piece, const Ray& ray) {
  const Frustum frustum(piece);
  if (frustum.height == 0) return std::nullopt;
  // Solved about the place on the ray nearest to the piece: far scanners would lose thin twigs in
  // the rounding of squared distances.
  const double shift = (piece.from - ray.origin).dot(ray.direction);
  const Eigen::Vector3d start = ray.origin + shift * ray.direction - piece.from;
  const double along = ray.direction.dot(frustum.axis);
  const double startAlong = start.dot(frustum.axis);
  const double startRadius = piece.fromRadius + frustum.slope * startAlong;
  // |across|^2 = radius^2 at start + t direction:  a t^2 + 2 b t + c = 0
  const double a = 1 - along * along * (1 + frustum.slope * frustum.slope);
  const double b = start.dot(ray.direction) - along * (startAlong + frustum.slope * startRadius);
  const double c = start.squaredNorm() - startAlong * startAlong - startRadius * startRadius;
  const double discriminant = b * b - a * c;
  if (discriminant < 0 || std::abs(a) < 1e-14) return std::nullopt;
  const double root = std::sqrt(discriminant);
  std::optional<WoodHit> result;
  for (const double t : {(-b - root) / a, (-b + root) / a}) {
    const double height = startAlong + t * along;
    const double range = t + shift;
    if (height < 0 || height > frustum.height || !(range > 0)) continue;
    if (result && result->range <= range) continue;
    const Eigen::Vector3d across = start + t * ray.direction - height * frustum.axis;
    const Eigen::Vector3d normal = normalAt(frustum, across);
    if (normal.dot(ray.direction) < 0) result = WoodHit{range, normal, piece.node};
  }
  return result;
}

std::optional<WoodHit> hitBall(const WoodPiece& piece, const Ray& ray) {
  const double nearest = (piece.to - ray.origin).dot(ray.direction);
  const Eigen::Vector3d across = ray.origin + nearest * ray.direction - piece.to;
  const double inside = piece.toRadius * piece.toRadius - across.squaredNorm();
  if (inside < 0) return std::nullopt;
  const double depth = std::sqrt(inside);
  const double range = nearest - depth;
  if (!(range > 0)) return std::nullopt;
  return WoodHit{range, (across - depth * ray.direction).normalized(), piece.node};
}

[[noreturn]] void refuse(NodeId id, const char* what) {
  throw Error(nameOf(id) + ": " + what);
}

} // namespace

std::vector<WoodPiece> woodOf(const Skeleton& plant) {
  std::vector<WoodPiece> wood;
  for (const NodeId id : plant.ids()) {
    const Node& node = plant[id];
    if (!node.position.allFinite()) refuse(id, "its position is not finite; move or delete it");
    if (!node.parent) continue;
    if (!(node.radius > 0) || !std::isfinite(node.radius))
      refuse(id, "it has no radius; give the plant radii first");
    const Node& parent = plant[*node.parent];
    const bool continues = node.edge == EdgeType::successor && parent.radius > 0;
    wood.push_back(
        {parent.position, node.position, continues ? parent.radius : node.radius, node.radius, id});
  }
  return wood;
}

std::optional<WoodHit> hit(const WoodPiece& piece, const Ray& ray) {
  std::optional<WoodHit> side = hitFrustum(piece, ray);
  std::optional<WoodHit> ball = hitBall(piece, ray);
  if (!side) return ball;
  if (!ball) return side;
  return side->range <= ball->range ? side : ball;
}

double signedDistance(const WoodPiece& piece, const Eigen::Vector3d& place) {
  const double ball = (place - piece.to).norm() - piece.toRadius;
  const Frustum frustum(piece);
  if (frustum.height == 0) return ball;
  const Eigen::Vector3d start = place - piece.from;
  const double along = start.dot(frustum.axis);
  const double across = (start - along * frustum.axis).norm();
  // In the half plane through the axis: the frustum is a trapezoid under its slanted side.
  const double lean = std::sqrt(1 + frustum.slope * frustum.slope);
  const double above = (across - piece.fromRadius - frustum.slope * along) / lean;
  const double foot = (along + frustum.slope * (across - piece.fromRadius)) / lean; // on the side
  const double side = frustum.height * lean;
  const double beyond = foot < 0 ? foot : std::max(0.0, foot - side);
  if (above <= 0 && along >= 0 && along <= frustum.height) return std::min(above, ball);
  if (above <= 0) return std::min(ball, std::max(-along, along - frustum.height));
  return std::min(ball, std::hypot(above, beyond));
}

double lateralArea(const WoodPiece& piece) {
  const double height = (piece.to - piece.from).norm();
  return std::numbers::pi * (piece.fromRadius + piece.toRadius) *
         std::hypot(height, piece.toRadius - piece.fromRadius);
}

Eigen::AlignedBox3d boundsOf(const WoodPiece& piece) {
  Eigen::AlignedBox3d box;
  box.extend((piece.from.array() - piece.fromRadius).matrix());
  box.extend((piece.from.array() + piece.fromRadius).matrix());
  box.extend((piece.to.array() - piece.toRadius).matrix());
  box.extend((piece.to.array() + piece.toRadius).matrix());
  return box;
}

} // namespace espalier
