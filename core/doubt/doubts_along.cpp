#include "core/doubt/doubts_along.h"

#include <algorithm>

namespace espalier {
namespace {

/// An edge of a missing branch, and how far from it its points may lie.
struct MissingEdge {
  Eigen::Vector3d from;
  Eigen::Vector3d to;
  double reach; // [L]

  [[nodiscard]] bool isNear(const Eigen::Vector3d& place) const {
    const Eigen::Vector3d along = to - from;
    const double square = along.squaredNorm();
    const double share = square > 0 ? std::clamp((place - from).dot(along) / square, 0.0, 1.0) : 0;
    return (from + share * along - place).squaredNorm() <= reach * reach;
  }
};

struct MissingEdges {
  std::size_t doubt;
  std::vector<MissingEdge> edges;
  Eigen::AlignedBox3d box; // about all that is near
};

MissingEdges edgesOf(std::size_t doubt, const Skeleton& branch, double near) {
  MissingEdges all{.doubt = doubt, .edges = {}, .box = {}};
  for (const NodeId id : branch.ids()) {
    const Node& node = branch[id];
    if (!node.parent) continue;
    const double reach = std::max(near, 2 * node.radius);
    all.edges.push_back({branch[*node.parent].position, node.position, reach});
    for (const Eigen::Vector3d& end : {all.edges.back().from, all.edges.back().to}) {
      all.box.extend(end - Eigen::Vector3d::Constant(reach));
      all.box.extend(end + Eigen::Vector3d::Constant(reach));
    }
  }
  return all;
}

std::vector<MissingEdges> missingEdges(const std::vector<Doubt>& doubts, double near) {
  std::vector<MissingEdges> all;
  for (std::size_t i = 0; i < doubts.size(); ++i)
    for (const Alternative& alternative : doubts[i].alternatives)
      if (alternative.branch) all.push_back(edgesOf(i, alternative.branch->part, near));
  return all;
}

std::optional<std::size_t> doubtAlong(const Finding& finding, const std::vector<MissingEdges>& all,
                                      const PointCloud& cloud) {
  constexpr std::size_t most = 64; // points that are looked at
  const std::size_t step = 1 + (finding.points.size() - 1) / most;
  std::vector<Eigen::Vector3d> places;
  for (std::size_t i = 0; i < finding.points.size(); i += step)
    places.push_back(cloud.position(finding.points[i]));
  std::vector<bool> isAlong(places.size(), false);
  std::size_t along = 0;
  std::optional<std::size_t> doubt;
  std::size_t mostAlong = 0;
  for (const MissingEdges& branch : all) {
    std::size_t own = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      if (!branch.box.contains(places[i])) continue;
      const auto isNear = [&](const MissingEdge& edge) { return edge.isNear(places[i]); };
      if (!std::ranges::any_of(branch.edges, isNear)) continue;
      ++own;
      if (!isAlong[i]) ++along;
      isAlong[i] = true;
    }
    if (own > mostAlong) {
      mostAlong = own;
      doubt = branch.doubt;
    }
  }
  return 2 * along > places.size() ? doubt : std::nullopt;
}

} // namespace

std::vector<std::optional<std::size_t>> doubtsAlong(const std::vector<Finding>& findings,
                                                    const std::vector<Doubt>& doubts,
                                                    const PointCloud& cloud, double near) {
  const std::vector<MissingEdges> branches = missingEdges(doubts, near);
  std::vector<std::optional<std::size_t>> along(findings.size());
  for (std::size_t i = 0; i < findings.size(); ++i)
    if (!findings[i].points.empty()) along[i] = doubtAlong(findings[i], branches, cloud);
  return along;
}

} // namespace espalier
