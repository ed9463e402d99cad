#include "core/skeleton/simplify_axes.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace espalier {
namespace {

bool mustStay(const Skeleton& skeleton, NodeId id) {
  const Node& node = skeleton[id];
  const std::vector<NodeId>& children = skeleton.children(id);
  return !node.parent || children.size() != 1 ||
         skeleton[children.front()].edge == EdgeType::branching ||
         node.edge == EdgeType::branching || !node.entities.empty() || node.isMarked ||
         node.review != ReviewMark{};
}

double distanceToLine(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                      const Eigen::Vector3d& place) {
  const Eigen::Vector3d along = to - from;
  const double length = along.squaredNorm();
  const double share = length > 0 ? std::clamp((place - from).dot(along) / length, 0.0, 1.0) : 0;
  return (place - from - share * along).norm();
}

/// Which nodes of a stretch stay, its ends included.
std::vector<bool> staying(const Skeleton& skeleton, const std::vector<NodeId>& stretch,
                          double tolerance) {
  std::vector<bool> stays(stretch.size(), false);
  stays.front() = stays.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open = {{0, stretch.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    std::size_t farthest = first;
    double most = tolerance;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double off =
          distanceToLine(skeleton[stretch[first]].position, skeleton[stretch[last]].position,
                         skeleton[stretch[i]].position);
      if (off <= most) continue;
      most = off;
      farthest = i;
    }
    if (farthest == first) continue;
    stays[farthest] = true;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, last);
  }
  return stays;
}

/// From a node that stays to the next one down that does.
std::vector<NodeId> stretchBelow(const Skeleton& skeleton, NodeId top) {
  std::vector<NodeId> stretch = {top};
  do
    stretch.push_back(*skeleton[stretch.back()].parent);
  while (!mustStay(skeleton, stretch.back()));
  return stretch;
}

} // namespace

Skeleton withSimpleAxes(const Skeleton& skeleton, double tolerance) {
  Skeleton result = skeleton;
  for (const NodeId top : skeleton.ids()) {
    if (!skeleton[top].parent || !mustStay(skeleton, top)) continue;
    const std::vector<NodeId> stretch = stretchBelow(skeleton, top);
    const std::vector<bool> stays = staying(skeleton, stretch, tolerance);
    NodeId above = top;
    for (std::size_t i = 1; i < stretch.size(); ++i) {
      if (!stays[i]) continue;
      const EdgeType edge = skeleton[above].edge;
      if (result[above].parent != stretch[i]) result.reparent(above, stretch[i], edge);
      above = stretch[i];
    }
    for (std::size_t i = 1; i + 1 < stretch.size(); ++i) // the upper first: then it has no child
      if (!stays[i]) result.erase(stretch[i]);
  }
  return result;
}

} // namespace espalier
