#include "core/skeleton/edge_index.h"

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

std::vector<EdgeBody> centerLines(const Skeleton& skeleton) {
  std::vector<EdgeBody> edges;
  edges.reserve(skeleton.size());
  for (const NodeId id : skeleton.ids())
    edges.push_back({id, centerLine(skeleton, id)});
  return edges;
}

BoxTree boxesOf(const std::vector<EdgeBody>& edges) {
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(edges.size());
  for (const EdgeBody& edge : edges) {
    const Eigen::AlignedBox3d line = edge.body.centerBox(); // holds all places that are compared
    const Eigen::Vector3d wood =
        Eigen::Vector3d::Constant(std::max(edge.body.fromRadius, edge.body.toRadius));
    boxes.emplace_back(line.min() - wood, line.max() + wood);
  }
  return BoxTree(std::move(boxes));
}

} // namespace

EdgeIndex::EdgeIndex(const Skeleton& skeleton) : EdgeIndex(centerLines(skeleton)) {}

EdgeIndex::EdgeIndex(std::vector<EdgeBody> edges)
    : edges_(std::move(edges)), boxes_(boxesOf(edges_)) {}

std::optional<NearestPlace> EdgeIndex::nearest(const Eigen::Vector3d& place) const {
  const auto found = boxes_.nearest(place, [&](std::size_t i) {
    const Frustum& body = edges_[i].body;
    return (body.at(body.nearestShare(place)) - place).squaredNorm();
  });
  if (!found) return std::nullopt;
  const Frustum& body = edges_[*found].body;
  const double share = body.nearestShare(place);
  NearestPlace result{edges_[*found].node, body.at(share), Eigen::Vector3d::Zero(), 0, share};
  if (share > 0 && share < 1) result.along = (body.to - body.from).normalized();
  result.distance = (result.position - place).norm();
  return result;
}

} // namespace espalier
