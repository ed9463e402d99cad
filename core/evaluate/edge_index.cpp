#include "core/evaluate/edge_index.h"

#include <algorithm>

namespace espalier {

Eigen::AlignedBox3d EdgeIndex::Edge::box() const {
  Eigen::AlignedBox3d result(start);
  result.extend(start + way);
  return result;
}

double EdgeIndex::Edge::nearestShare(const Eigen::Vector3d& place) const {
  const double squared = way.squaredNorm();
  return squared > 0 ? std::clamp(way.dot(place - start) / squared, 0.0, 1.0) : 0;
}

EdgeIndex::EdgeIndex(const Skeleton& skeleton)
    : edges_(edgesOf(skeleton)), boxes_(boxesOf(edges_)) {}

std::vector<EdgeIndex::Edge> EdgeIndex::edgesOf(const Skeleton& skeleton) {
  std::vector<Edge> edges;
  edges.reserve(skeleton.size());
  for (const NodeId id : skeleton.ids()) {
    const Node& node = skeleton[id];
    const Eigen::Vector3d start = node.parent ? skeleton[*node.parent].position : node.position;
    edges.push_back({id, start, node.position - start});
  }
  return edges;
}

BoxTree EdgeIndex::boxesOf(const std::vector<Edge>& edges) {
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(edges.size());
  for (const Edge& edge : edges)
    boxes.push_back(edge.box());
  return BoxTree(std::move(boxes));
}

std::optional<NearestPlace> EdgeIndex::nearest(const Eigen::Vector3d& place) const {
  const auto found = boxes_.nearest(place, [&](std::size_t i) {
    const Edge& edge = edges_[i];
    return (edge.start + edge.nearestShare(place) * edge.way - place).squaredNorm();
  });
  if (!found) return std::nullopt;
  const Edge& edge = edges_[*found];
  const double share = edge.nearestShare(place);
  NearestPlace result{edge.node, edge.start + share * edge.way, Eigen::Vector3d::Zero(), 0};
  if (share > 0 && share < 1) result.along = edge.way.normalized();
  result.distance = (result.position - place).norm();
  return result;
}

} // namespace espalier
