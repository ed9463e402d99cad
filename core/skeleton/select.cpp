#include "core/skeleton/select.h"

#include "core/base/shown_message.h"
#include "core/skeleton/axes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace espalier {
namespace {

/// Nodes in the order they were taken, and which ones they are.
class Choice {
public:
  explicit Choice(const Skeleton& skeleton) : isTaken_(skeleton.idEnd(), false) {}
  Choice(const Skeleton& skeleton, const std::vector<NodeId>& nodes) : Choice(skeleton) {
    for (const NodeId id : nodes)
      take(id);
  }

  [[nodiscard]] bool has(NodeId id) const { return isTaken_[indexOf(id)]; }
  [[nodiscard]] const std::vector<NodeId>& nodes() const { return nodes_; }

  /// Returns whether it is new.
  bool take(NodeId id) {
    if (has(id)) return false;
    isTaken_[indexOf(id)] = true;
    nodes_.push_back(id);
    return true;
  }

private:
  std::vector<bool> isTaken_; // by id
  std::vector<NodeId> nodes_;
};

template <class Accepts> std::vector<NodeId> allThat(const Skeleton& skeleton, Accepts accepts) {
  std::vector<NodeId> result = skeleton.ids();
  std::erase_if(result, [&](NodeId id) { return !accepts(id); });
  return result;
}

} // namespace

std::vector<NodeId> downstream(const Skeleton& skeleton, const std::vector<NodeId>& nodes) {
  Choice choice(skeleton, nodes);
  for (std::size_t next = 0; next < choice.nodes().size(); ++next)
    for (const NodeId child : skeleton.children(choice.nodes()[next]))
      choice.take(child);
  return choice.nodes();
}

std::vector<NodeId> upstream(const Skeleton& skeleton, const std::vector<NodeId>& nodes) {
  Choice choice(skeleton);
  for (const NodeId id : nodes)
    for (std::optional<NodeId> at = id; at && choice.take(*at); at = skeleton[*at].parent) {
    }
  return choice.nodes();
}

std::vector<NodeId> axesThrough(const Skeleton& skeleton, const std::vector<NodeId>& nodes) {
  Choice choice(skeleton);
  for (const NodeId id : nodes) {
    if (choice.has(id)) continue; // with its whole axis
    for (const NodeId each : axisThrough(skeleton, id))
      choice.take(each);
  }
  return choice.nodes();
}

std::vector<NodeId> ofSameOrder(const Skeleton& skeleton, const std::vector<NodeId>& nodes) {
  const std::vector<int> byNode = orders(skeleton);
  std::vector<bool> isMeant(skeleton.size() + 1, false); // by order
  for (const NodeId id : nodes)
    isMeant[static_cast<std::size_t>(byNode[indexOf(id)])] = true;
  return allThat(skeleton,
                 [&](NodeId id) { return isMeant[static_cast<std::size_t>(byNode[indexOf(id)])]; });
}

std::vector<NodeId> treesOf(const Skeleton& skeleton, const std::vector<NodeId>& nodes) {
  Choice roots(skeleton);
  for (const NodeId id : upstream(skeleton, nodes))
    if (!skeleton[id].parent) roots.take(id);
  return downstream(skeleton, roots.nodes());
}

std::vector<NodeId> ofSimilarRadius(const Skeleton& skeleton, const std::vector<NodeId>& nodes,
                                    double share) {
  assert(share >= 0 && share <= 1);
  double sum = 0;
  int known = 0;
  for (const NodeId id : nodes)
    if (skeleton[id].radius > 0) {
      sum += skeleton[id].radius;
      ++known;
    }
  if (known == 0)
    throw ShownError(
        {Shown::tr("the chosen nodes have no radius yet: type one in the inspector first")});
  const double mean = sum / known;
  constexpr double rounding = 1e-9;
  return allThat(skeleton, [&](NodeId id) {
    return std::abs(skeleton[id].radius - mean) <= (share + rounding) * mean;
  });
}

std::vector<NodeId> grown(const Skeleton& skeleton, const std::vector<NodeId>& nodes) {
  Choice choice(skeleton, nodes);
  for (const NodeId id : nodes) {
    if (skeleton[id].parent) choice.take(*skeleton[id].parent);
    for (const NodeId child : skeleton.children(id))
      choice.take(child);
  }
  return choice.nodes();
}

std::vector<NodeId> shrunk(const Skeleton& skeleton, const std::vector<NodeId>& nodes) {
  const Choice before(skeleton, nodes);
  std::vector<NodeId> result = before.nodes();
  std::erase_if(result, [&](NodeId id) {
    const std::optional<NodeId>& parent = skeleton[id].parent;
    return (parent && !before.has(*parent)) ||
           !std::ranges::all_of(skeleton.children(id),
                                [&](NodeId child) { return before.has(child); });
  });
  return result;
}

std::vector<NodeId> inverted(const Skeleton& skeleton, const std::vector<NodeId>& nodes) {
  const Choice before(skeleton, nodes);
  return allThat(skeleton, [&](NodeId id) { return !before.has(id); });
}

std::vector<NodeId> notReviewed(const Skeleton& skeleton) {
  return allThat(skeleton,
                 [&](NodeId id) { return skeleton[id].review.state != ReviewState::reviewed; });
}

std::vector<NodeId> pathBetween(const Skeleton& skeleton, NodeId from, NodeId to) {
  std::vector<NodeId> up = upstream(skeleton, {from});
  std::vector<NodeId> down = upstream(skeleton, {to});
  if (up.back() != down.back())
    throw ShownError({Shown::tr("node %1 and node %2 belong to different trees: choose two of one "
                                "tree, or join them first"),
                      {std::to_string(indexOf(from)), std::to_string(indexOf(to))}});
  while (up.size() > 1 && down.size() > 1 && up[up.size() - 2] == down[down.size() - 2]) {
    up.pop_back();
    down.pop_back();
  }
  if (up.size() > 1 && down.size() == 1) return up; // `to` carries `from`
  up.pop_back();                                    // the node where the paths meet is in `down`
  up.insert(up.end(), down.rbegin(), down.rend());
  return up;
}

std::vector<NodeId> pathOf(const Skeleton& skeleton, const std::vector<NodeId>& nodes) {
  assert(!nodes.empty());
  if (nodes.size() == 1) return axisThrough(skeleton, nodes.front());
  return pathBetween(skeleton, nodes.front(), nodes.back());
}

std::optional<NodeId> stepFrom(const Skeleton& skeleton, NodeId id, NodeStep step) {
  const std::vector<NodeId>& children = skeleton.children(id);
  if (step == NodeStep::child) {
    const std::optional<NodeId> next = nextOnAxis(skeleton, id);
    return next || children.empty() ? next : std::optional(children.front());
  }
  const std::optional<NodeId> parent = skeleton[id].parent;
  if (step == NodeStep::parent || !parent) return parent;
  const std::vector<NodeId>& siblings = skeleton.children(*parent);
  const std::size_t count = siblings.size();
  if (count < 2) return std::nullopt;
  const auto at = static_cast<std::size_t>(std::ranges::find(siblings, id) - siblings.begin());
  return siblings[(at + (step == NodeStep::nextSibling ? 1 : count - 1)) % count];
}

} // namespace espalier
