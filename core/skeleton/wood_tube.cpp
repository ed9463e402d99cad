#include "core/skeleton/wood_tube.h"

#include <algorithm>

namespace espalier {

Eigen::AlignedBox3d WoodTube::centerBox() const {
  Eigen::AlignedBox3d box(from);
  box.extend(to);
  return box;
}

double WoodTube::widest() const {
  return std::max(fromRadius, toRadius);
}

std::optional<WoodTube> tubeOf(const Skeleton& skeleton, NodeId id) {
  const Node& node = skeleton[id];
  if (!node.parent) {
    if (!skeleton.children(id).empty()) return std::nullopt;
    return WoodTube{node.position, node.position, node.radius, node.radius};
  }
  const Node& parent = skeleton[*node.parent];
  const double fromRadius = node.edge == EdgeType::successor ? parent.radius : node.radius;
  return WoodTube{parent.position, node.position, fromRadius, node.radius};
}

NearestOfTubes nearestOf(const WoodTube& a, const WoodTube& b) {
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
