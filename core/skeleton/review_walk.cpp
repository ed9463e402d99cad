#include "core/skeleton/review_walk.h"

#include "core/skeleton/bounds.h"
#include "core/skeleton/length_along.h"

#include <algorithm>
#include <optional>
#include <unordered_set>
#include <utility>

namespace espalier {
std::vector<Axis> axesInWalkOrder(const Skeleton& skeleton) {
  std::vector<Axis> all = axes(skeleton);
  std::vector<std::optional<std::size_t>> beginning(skeleton.idEnd()); // axes, by first node
  for (std::size_t i = 0; i < all.size(); ++i)
    beginning[indexOf(all[i].front())] = i;

  std::vector<std::size_t> waiting; // the next one last
  const std::vector<NodeId> roots = skeleton.roots();
  for (auto root = roots.rbegin(); root != roots.rend(); ++root)
    waiting.push_back(*beginning[indexOf(*root)]);
  std::vector<Axis> result;
  result.reserve(all.size());
  while (!waiting.empty()) {
    Axis& axis = all[waiting.back()];
    waiting.pop_back();
    for (auto at = axis.rbegin(); at != axis.rend(); ++at) {
      const std::vector<NodeId>& children = skeleton.children(*at);
      for (auto child = children.rbegin(); child != children.rend(); ++child)
        if (const auto begun = beginning[indexOf(*child)]) waiting.push_back(*begun);
    }
    result.push_back(std::move(axis));
  }
  return result;
}

std::vector<Stretch> stretches(const Skeleton& skeleton, double longest) {
  std::vector<Stretch> result;
  for (const Axis& axis : axesInWalkOrder(skeleton))
    for (Stretch& stretch : stretchesAlong(skeleton, axis, longest))
      result.push_back(std::move(stretch));
  return result;
}

std::vector<Stretch> stretchesAlong(const Skeleton& skeleton, const Axis& part, double longest) {
  std::vector<Stretch> result;
  Stretch stretch;
  double length = 0;
  const auto end = [&] {
    if (!stretch.empty()) result.push_back(std::exchange(stretch, {}));
    length = 0;
  };
  for (const NodeId id : part) {
    const double edge = edgeLength(skeleton, id);
    if (length > 0 && length + edge > longest) end();
    stretch.push_back(id);
    length += edge;
    if (skeleton.children(id).size() > 1) end();
  }
  end();
  return result;
}

double longestStretch(const Skeleton& skeleton) {
  if (skeleton.isEmpty()) return 0;
  return bounds(skeleton).diagonal().norm() / 10;
}

bool isOneLook(const Skeleton& skeleton, const std::vector<NodeId>& nodes) {
  if (nodes.empty()) return true;
  const Axis axis = axisThrough(skeleton, nodes.front());
  const std::unordered_set<NodeId> ofAxis(axis.begin(), axis.end());
  if (std::ranges::all_of(nodes, [&](NodeId id) { return ofAxis.contains(id); })) return true;
  double length = 0;
  for (const NodeId id : nodes)
    length += edgeLength(skeleton, id);
  return length <= longestLook * longestStretch(skeleton);
}

} // namespace espalier
