#include "core/skeleton/length_along.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace espalier {
namespace {

/// From the root to the node.
std::vector<NodeId> pathTo(const Skeleton& skeleton, NodeId id) {
  std::vector<NodeId> path;
  for (std::optional<NodeId> at = id; at; at = skeleton[*at].parent)
    path.push_back(*at);
  std::ranges::reverse(path);
  return path;
}

/// From the foot of the edge of `path[first]` to a place on the last edge of the path.
double lengthOf(const Skeleton& skeleton, const std::vector<NodeId>& path, std::size_t first,
                const SkeletonPlace& place) {
  double length = 0;
  for (std::size_t i = first; i + 1 < path.size(); ++i)
    length += edgeLength(skeleton, path[i]);
  return length + place.fraction * edgeLength(skeleton, path.back());
}

} // namespace

double edgeLength(const Skeleton& skeleton, NodeId id) {
  const Node& node = skeleton[id];
  return node.parent ? (node.position - skeleton[*node.parent].position).norm() : 0;
}

std::vector<double> carriedLengths(const Skeleton& skeleton) {
  std::vector<double> carried(skeleton.idEnd(), 0);
  const std::vector<NodeId> ids = skeleton.ids();
  for (auto id = ids.rbegin(); id != ids.rend(); ++id)
    if (const auto parent = skeleton[*id].parent)
      carried[indexOf(*parent)] += carried[indexOf(*id)] + edgeLength(skeleton, *id);
  return carried;
}

Eigen::Vector3d positionOf(const Skeleton& skeleton, const SkeletonPlace& place) {
  const Node& node = skeleton[place.node];
  if (!node.parent) return node.position;
  const Eigen::Vector3d& foot = skeleton[*node.parent].position;
  return foot + place.fraction * (node.position - foot);
}

std::optional<double> lengthAlong(const Skeleton& skeleton, const SkeletonPlace& from,
                                  const SkeletonPlace& to) {
  const std::vector<NodeId> a = pathTo(skeleton, from.node);
  const std::vector<NodeId> b = pathTo(skeleton, to.node);
  if (a.front() != b.front()) return std::nullopt;
  const auto shared = static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin()); // >= 1
  // One on the path to the other: both are measured from the foot of the last edge they share.
  const bool isOnPath = shared == a.size() || shared == b.size();
  const std::size_t first = isOnPath ? shared - 1 : shared;
  const double lengthA = lengthOf(skeleton, a, first, from);
  const double lengthB = lengthOf(skeleton, b, first, to);
  return isOnPath ? std::abs(lengthA - lengthB) : lengthA + lengthB;
}

} // namespace espalier
