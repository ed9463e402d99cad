#include "core/skeleton/review_walk.h"

#include "core/skeleton/bounds.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace espalier {
namespace {

bool isReviewed(const Skeleton& skeleton, NodeId id) {
  return skeleton[id].review.state == ReviewState::reviewed;
}

bool isToDo(const Skeleton& skeleton, NodeId id) {
  return skeleton[id].review.state == ReviewState::toDo;
}

bool leadsTo(const Skeleton& skeleton, const Stretch& stretch, WalkTo to) {
  const NodeId last = stretch.back(); // a stretch ends where an end or a branching is
  switch (to) {
  case WalkTo::anyStretch:
    return true;
  case WalkTo::toDo:
    return std::ranges::any_of(stretch, [&](NodeId id) { return isToDo(skeleton, id); });
  case WalkTo::notReviewed:
    return !std::ranges::all_of(stretch, [&](NodeId id) { return isReviewed(skeleton, id); });
  case WalkTo::openEnd:
    return skeleton.children(last).empty() && !isReviewed(skeleton, last);
  case WalkTo::branching:
    return skeleton.children(last).size() > 1 && !isReviewed(skeleton, last);
  }
  return false;
}

void addStretches(const Skeleton& skeleton, const Axis& axis, double longest,
                  std::vector<Stretch>& to) {
  Stretch stretch;
  double length = 0;
  const auto end = [&] {
    if (!stretch.empty()) to.push_back(std::exchange(stretch, {}));
    length = 0;
  };
  for (const NodeId id : axis) {
    const Node& node = skeleton[id];
    const double edge =
        node.parent ? (node.position - skeleton[*node.parent].position).norm() : 0.0;
    if (length > 0 && length + edge > longest) end();
    stretch.push_back(id);
    length += edge;
    if (skeleton.children(id).size() > 1) end();
  }
  end();
}

} // namespace

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
    addStretches(skeleton, axis, longest, result);
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
    if (const auto parent = skeleton[id].parent)
      length += (skeleton[id].position - skeleton[*parent].position).norm();
  return length <= 2 * longestStretch(skeleton);
}

std::optional<std::size_t> stretchOf(const std::vector<Stretch>& stretches, NodeId id) {
  for (std::size_t i = 0; i < stretches.size(); ++i)
    if (std::ranges::find(stretches[i], id) != stretches[i].end()) return i;
  return std::nullopt;
}

std::optional<std::size_t> walk(const Skeleton& skeleton, const std::vector<Stretch>& stretches,
                                std::optional<std::size_t> from, WalkTo to,
                                WalkDirection direction) {
  const std::size_t count = stretches.size();
  const bool isForward = direction == WalkDirection::forward;
  std::size_t at = from.value_or(isForward ? count - 1 : 0);
  for (std::size_t tried = 0; tried < count; ++tried) {
    at = (at + (isForward ? 1 : count - 1)) % count;
    if (leadsTo(skeleton, stretches[at], to)) return at;
  }
  return std::nullopt;
}

} // namespace espalier
