#include "core/skeleton/crossings.h"

#include "core/base/box_tree.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/frustum.h"
#include "core/skeleton/length_along.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace espalier {
namespace {

/// Path lengths along a plant: how far its nodes are from their roots.
class PathLengths {
public:
  PathLengths(const Skeleton& skeleton, const std::vector<NodeId>& ids)
      : skeleton_(skeleton), levels_(skeleton.idEnd()), lengths_(skeleton.idEnd()) {
    for (const NodeId id : ids)
      if (const auto parent = skeleton[id].parent) {
        levels_[indexOf(id)] = levels_[indexOf(*parent)] + 1;
        lengths_[indexOf(id)] = lengths_[indexOf(*parent)] + edgeLength(skeleton, id);
      }
  }

  /// Between two places, each a share of the edge up to a node [L]; infinite between two trees.
  [[nodiscard]] double between(NodeId a, double shareA, NodeId b, double shareB) const {
    const double toA = lengths_[indexOf(a)] - (1 - shareA) * edgeLength(skeleton_, a);
    const double toB = lengths_[indexOf(b)] - (1 - shareB) * edgeLength(skeleton_, b);
    const auto joint = commonAncestor(a, b);
    if (!joint) return std::numeric_limits<double>::infinity();
    // Where the one node carries the other, its own place on the edge below is the lower end.
    const double lowest = std::min({lengths_[indexOf(*joint)], toA, toB});
    return toA + toB - 2 * lowest;
  }

private:
  [[nodiscard]] std::optional<NodeId> commonAncestor(NodeId a, NodeId b) const {
    while (a != b) {
      NodeId& higher = levels_[indexOf(a)] >= levels_[indexOf(b)] ? a : b;
      if (!skeleton_[higher].parent) return std::nullopt;
      higher = *skeleton_[higher].parent;
    }
    return a;
  }

  const Skeleton& skeleton_;
  std::vector<int> levels_;     // by id
  std::vector<double> lengths_; // by id
};

/// The number of the axis of each node, by id.
std::vector<std::uint32_t> axisNumbers(const Skeleton& skeleton) {
  std::vector<std::uint32_t> numbers(skeleton.idEnd());
  std::uint32_t number = 0;
  for (const Axis& axis : axes(skeleton)) {
    for (const NodeId id : axis)
      numbers[indexOf(id)] = number;
    ++number;
  }
  return numbers;
}

/// Numbers of the nodes that bear edges: those of one node meet there, and all their boxes do.
std::vector<std::uint32_t> parentsOf(const Skeleton& skeleton, const std::vector<EdgeBody>& edges) {
  std::vector<std::uint32_t> parents;
  parents.reserve(edges.size());
  for (const EdgeBody& edge : edges) {
    const std::optional<NodeId> parent = skeleton[edge.node].parent;
    parents.push_back(parent ? static_cast<std::uint32_t>(*parent) : BoxTree::noGroup);
  }
  return parents;
}

bool areNeighbors(const Skeleton& skeleton, NodeId a, NodeId b) {
  const auto underA = skeleton[a].parent;
  const auto underB = skeleton[b].parent;
  return underA == b || underB == a || (underA && underA == underB);
}

/// Whether no more than `rest` [L] of an axis follows a place of one of its edges.
bool isEnd(const Skeleton& skeleton, NodeId id, double share, double rest) {
  return skeleton.children(id).empty() && (1 - share) * edgeLength(skeleton, id) <= rest;
}

} // namespace

std::vector<Finding> crossings(const Skeleton& skeleton, double spacing,
                               const CheckOptions& options) {
  const std::vector<NodeId> ids = skeleton.ids();
  const std::vector<EdgeBody> edges = bodiesOf(skeleton);
  const std::vector<std::uint32_t> axis = axisNumbers(skeleton);
  const PathLengths lengths(skeleton, ids);
  std::vector<Eigen::AlignedBox3d> boxes;
  boxes.reserve(edges.size());
  for (const EdgeBody& edge : edges)
    boxes.push_back(edge.body.box());
  const std::vector<std::uint32_t> parents = parentsOf(skeleton, edges);
  const BoxTree tree(boxes, parents);

  struct Touch {
    double gap = std::numeric_limits<double>::infinity(); // between the surfaces [L]
    std::size_t edge = 0;                                 // the later one
    Finding finding{.kind = Finding::Kind::crossing, .node = {}};
  };
  std::map<std::pair<std::uint32_t, std::uint32_t>, Touch> touches; // by pair of axes
  const double thin = options.touch * spacing;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto look = [&](std::size_t k) {
      const NodeId a = edges[i].node;
      const NodeId b = edges[k].node;
      if (k >= i || areNeighbors(skeleton, a, b)) return;
      const NearestShares near = nearestShares(edges[i].body, edges[k].body);
      const double wood = edges[i].body.radiusAt(near.a) + edges[k].body.radiusAt(near.b);
      const double touching = std::max(wood, thin);
      if (near.distance > touching) return;
      if (lengths.between(a, near.a, b, near.b) <= options.detour * touching) return;
      Touch& touch = touches[std::minmax(axis[indexOf(a)], axis[indexOf(b)])];
      const double gap = near.distance - wood;
      if (gap > touch.gap || (gap == touch.gap && i > touch.edge)) return;
      touch.gap = gap;
      touch.edge = i;
      const double rest = 2 * touching;
      const bool endsA = isEnd(skeleton, a, near.a, rest);
      const bool endsB = !endsA && isEnd(skeleton, b, near.b, rest);
      touch.finding.kind = endsA || endsB ? Finding::Kind::loop : Finding::Kind::crossing;
      touch.finding.node = endsB ? b : a;
      touch.finding.others = {endsB ? a : b};
      touch.finding.amount = near.distance;
    };
    tree.within(boxes[i], thin, look, parents[i]); // without its siblings
  }
  std::vector<const Touch*> inOrder;
  inOrder.reserve(touches.size());
  for (const auto& [pair, touch] : touches)
    inOrder.push_back(&touch);
  std::ranges::stable_sort(inOrder, {}, &Touch::edge);
  std::vector<Finding> findings;
  findings.reserve(inOrder.size());
  for (const Touch* touch : inOrder)
    findings.push_back(touch->finding);
  return findings;
}

} // namespace espalier
