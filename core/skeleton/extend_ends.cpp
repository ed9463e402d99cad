#include "core/skeleton/extend_ends.h"

#include "core/skeleton/assign_points.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace espalier {
namespace {

/// An end of the skeleton and the direction out of it.
struct End {
  NodeId node;
  Eigen::Vector3d outwards; // as long as the last edge
};

std::vector<End> endsOf(const Skeleton& skeleton) {
  std::vector<End> ends;
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    const std::vector<NodeId>& children = skeleton.children(id);
    if (node.parent && children.empty())
      ends.push_back({id, node.position - skeleton[*node.parent].position});
    else if (!node.parent && children.size() == 1)
      ends.push_back({id, node.position - skeleton[children.front()].position});
  }
  std::erase_if(ends, [](const End& end) { return end.outwards.isZero(0); });
  return ends;
}

/// The end that a point is beyond, if any.
std::optional<NodeId> endBelow(const Skeleton& skeleton, const PointOnSkeleton& place) {
  const std::optional<NodeId> parent = skeleton[place.child].parent;
  if (place.fraction >= 1 && skeleton.children(place.child).empty()) return place.child;
  if (place.fraction <= 0 && parent && !skeleton[*parent].parent) return parent;
  return std::nullopt;
}

} // namespace

Skeleton withExtendedEnds(const Skeleton& skeleton, const Eigen::Matrix3Xf& points,
                          const Eigen::Vector3d& origin, const Progress& progress) {
  Skeleton result = skeleton;
  if (skeleton.isEmpty() || points.cols() == 0) return result;
  const std::vector<PointOnSkeleton> places = assignPoints(points, origin, skeleton, progress);
  std::vector<std::vector<Eigen::Vector3d>> beyond(skeleton.idEnd());
  for (std::size_t i = 0; i < places.size(); ++i)
    if (const auto end = endBelow(skeleton, places[i]))
      beyond[indexOf(*end)].emplace_back(points.col(static_cast<Eigen::Index>(i)).cast<double>() +
                                         origin);
  for (const End& end : endsOf(skeleton)) {
    const double edge = end.outwards.norm();
    const Eigen::Vector3d outwards = end.outwards / edge;
    std::vector<double> reaches;
    for (const Eigen::Vector3d& point : beyond[indexOf(end.node)])
      reaches.push_back((point - skeleton[end.node].position).dot(outwards));
    if (reaches.empty()) continue;
    const auto kept = reaches.begin() + static_cast<std::ptrdiff_t>(reaches.size() * 9 / 10);
    std::nth_element(reaches.begin(), kept, reaches.end());
    const double reach = std::clamp(*kept, 0.0, edge);
    result.setPosition(end.node, skeleton[end.node].position + reach * outwards);
  }
  return result;
}

} // namespace espalier
