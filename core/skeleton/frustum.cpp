#include "core/skeleton/frustum.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {

double Frustum::lateralArea() const {
  return std::numbers::pi * (fromRadius + toRadius) * std::hypot(length(), toRadius - fromRadius);
}

double Frustum::volume() const {
  return std::numbers::pi / 3 * length() *
         (fromRadius * fromRadius + fromRadius * toRadius + toRadius * toRadius);
}

Eigen::AlignedBox3d Frustum::box() const {
  Eigen::AlignedBox3d box;
  box.extend((from.array() - fromRadius).matrix());
  box.extend((from.array() + fromRadius).matrix());
  box.extend((to.array() - toRadius).matrix());
  box.extend((to.array() + toRadius).matrix());
  return box;
}

Eigen::AlignedBox3d Frustum::centerBox() const {
  Eigen::AlignedBox3d box(from);
  box.extend(at(1)); // by rounding, not quite `to`
  return box;
}

std::optional<Frustum> frustumOf(const Skeleton& skeleton, NodeId id) {
  const Node& node = skeleton[id];
  if (!node.parent && !skeleton.children(id).empty()) return std::nullopt;
  Frustum frustum = centerLine(skeleton, id);
  frustum.fromRadius = frustum.toRadius = node.radius;
  if (!node.parent || node.edge != EdgeType::successor) return frustum;
  const double below = skeleton[*node.parent].radius;
  if (below > 0) frustum.fromRadius = below;
  return frustum;
}

Frustum centerLine(const Skeleton& skeleton, NodeId id) {
  const Node& node = skeleton[id];
  return {node.parent ? skeleton[*node.parent].position : node.position, node.position};
}

std::vector<EdgeBody> bodiesOf(const Skeleton& skeleton) {
  std::vector<EdgeBody> bodies;
  bodies.reserve(skeleton.size());
  for (const NodeId id : skeleton.ids())
    if (const auto body = frustumOf(skeleton, id)) bodies.push_back({id, *body});
  return bodies;
}

NearestShares nearestShares(const Frustum& a, const Frustum& b) {
  const Eigen::Vector3d alongA = a.to - a.from;
  const Eigen::Vector3d alongB = b.to - b.from;
  const Eigen::Vector3d apart = a.from - b.from;
  const double squaredA = alongA.squaredNorm();
  const double squaredB = alongB.squaredNorm();
  const double dot = alongA.dot(alongB);
  const double offA = alongA.dot(apart);
  const double offB = alongB.dot(apart);
  const double unlike = squaredA * squaredB - dot * dot; // 0: parallel, or one has no length
  double shareA = 0;
  if (unlike > 1e-12 * squaredA * squaredB)
    shareA = std::clamp((dot * offB - offA * squaredB) / unlike, 0.0, 1.0);
  double shareB = squaredB > 0 ? (dot * shareA + offB) / squaredB : 0;
  if (shareB < 0 || shareB > 1 || squaredB == 0) {
    shareB = std::clamp(shareB, 0.0, 1.0);
    shareA = squaredA > 0 ? std::clamp((dot * shareB - offA) / squaredA, 0.0, 1.0) : 0;
  }
  return {(apart + shareA * alongA - shareB * alongB).norm(), shareA, shareB};
}

} // namespace espalier
