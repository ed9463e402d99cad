#include "core/evaluate/traits/internodes.h"

#include "core/skeleton/axes.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numbers>

namespace espalier {
namespace {

using Eigen::Vector3d;

constexpr double fullTurn = 2 * std::numbers::pi;

/// The vector of the internode to `id`; zero for a root.
Vector3d internode(const Skeleton& skeleton, NodeId id) {
  const Node& node = skeleton[id];
  return node.parent ? Vector3d(node.position - skeleton[*node.parent].position) : Vector3d::Zero();
}

std::optional<double> angleBetween(const Vector3d& a, const Vector3d& b) {
  if (a.isZero(0) || b.isZero(0)) return std::nullopt;
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// `angle` in [0, 2 pi).
double wrapped(double angle) {
  const double rest = std::fmod(angle, fullTurn);
  const double result = rest < 0 ? rest + fullTurn : rest;
  return result < fullTurn ? result : 0; // a sum may round up to a full turn
}

/// The part of `v` that is perpendicular to the unit vector `along`.
Vector3d across(const Vector3d& v, const Vector3d& along) {
  return v - v.dot(along) * along;
}

/// Direction of an axis, and one that is perpendicular to it: both of length 1.
struct Frame {
  Vector3d along;
  Vector3d side;

  [[nodiscard]] std::optional<double> azimuth(const Vector3d& direction) const {
    constexpr double least = 1e-9; // of its length, by which a branch must leave the axis
    const double x = direction.dot(side);
    const double y = direction.dot(along.cross(side));
    if (!(std::hypot(x, y) > least * direction.norm())) return std::nullopt;
    return wrapped(std::atan2(y, x));
  }
};

Frame firstFrame(const Vector3d& along) {
  constexpr double nearX = 0.9; // cosine of an axis that goes along x
  const Vector3d from = std::abs(along.x()) < nearX ? Vector3d::UnitX() : Vector3d::UnitY();
  return {along, across(from, along).normalized()};
}

Frame carried(const Frame& frame, const Vector3d& along) {
  const Eigen::Quaterniond rotation = Eigen::Quaterniond::FromTwoVectors(frame.along, along);
  return {along, across(rotation * frame.side, along).normalized()};
}

/// Direction of the axis at its node `i`; that of `before` where nodes coincide.
Vector3d directionAt(const Skeleton& skeleton, const Axis& axis, std::size_t i,
                     const Vector3d& before) {
  Vector3d direction = internode(skeleton, axis[i]);
  if (i + 1 < axis.size()) direction += internode(skeleton, axis[i + 1]);
  return direction.isZero(0) ? before : direction.normalized();
}

/// Sets azimuth, divergence and spacing of what branches off an axis.
void measureBranches(const Skeleton& skeleton, const Axis& axis, std::vector<Internode>& result) {
  Frame frame = firstFrame(directionAt(skeleton, axis, 0, Vector3d::UnitZ()));
  double passed = 0;                  // along the axis
  std::optional<double> passedBefore; // at the branch before
  std::optional<double> angleBefore;  // of it
  for (std::size_t i = 0; i < axis.size(); ++i) {
    if (i > 0) {
      frame = carried(frame, directionAt(skeleton, axis, i, frame.along));
      passed += result[indexOf(axis[i])].length;
    }
    for (const NodeId child : skeleton.children(axis[i])) {
      if (i + 1 < axis.size() && child == axis[i + 1]) continue;
      Internode& branch = result[indexOf(child)];
      branch.azimuth = frame.azimuth(internode(skeleton, child));
      if (branch.azimuth && angleBefore)
        branch.divergence = wrapped(*branch.azimuth - *angleBefore);
      if (passedBefore) branch.spacing = passed - *passedBefore;
      passedBefore = passed;
      angleBefore = branch.azimuth;
    }
  }
}

} // namespace

std::vector<Internode> internodes(const Skeleton& skeleton) {
  std::vector<Internode> result(skeleton.idEnd());
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    if (!node.parent) continue;
    const Vector3d edge = internode(skeleton, id);
    Internode& entry = result[indexOf(id)];
    entry.length = edge.norm();
    entry.inclination = angleBetween(edge, Vector3d::UnitZ());
    entry.turn = angleBetween(internode(skeleton, *node.parent), edge);
  }
  for (const Axis& axis : axes(skeleton))
    measureBranches(skeleton, axis, result);
  return result;
}

} // namespace espalier
