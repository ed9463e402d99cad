#include "core/skeleton/slide_insertions.h"

#include "core/skeleton/axes.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

namespace espalier {
namespace {

using Eigen::Vector3d;

/// A node of an axis, and how far along the axis it is [L].
struct NodeAlong {
  double along = 0;
  NodeId node{};
};

/// Branches that leave an axis at one place.
struct Insertion {
  double along = 0;  // of the axis [L]
  double weight = 0; // how sharply their lines give the place
  std::vector<NodeId> branches;
};

/// The line back from a branch: from its first node, against its direction.
struct LineBack {
  Vector3d start;
  Vector3d direction; // unit
  double length = 0;  // how far it is followed [L]
};

std::optional<LineBack> lineBackFrom(const Skeleton& skeleton, NodeId branch) {
  constexpr int edges = 3; // single ones stray
  NodeId far = branch;
  for (int i = 0; i < edges; ++i) {
    const std::optional<NodeId> next = nextOnAxis(skeleton, far);
    if (!next) break;
    far = *next;
  }
  const Vector3d& start = skeleton[branch].position;
  const Vector3d back = start - skeleton[far].position;
  const double length = back.norm();
  if (!(length > 0)) return std::nullopt;
  const double gap = (start - skeleton[*skeleton[branch].parent].position).norm();
  return LineBack{start, back / length, 2 * gap};
}

/// Where a line back comes nearest to an edge, and how near.
struct Approach {
  double share = 0; // of the edge, from its lower end
  double distance = std::numeric_limits<double>::infinity();
  double sharpness = 0; // squared sine of the angle between the two
};

Approach nearestOn(const Vector3d& lower, const Vector3d& upper, const LineBack& line) {
  const Vector3d along = upper - lower;
  const Vector3d between = line.start - lower;
  const double a = along.squaredNorm();
  if (a == 0) return {};
  const double b = along.dot(line.direction);
  const double parallel = a - b * b; // of unit directions: sin^2, times a
  double t = parallel > 1e-9 * a
                 ? (b * along.dot(between) - a * line.direction.dot(between)) / parallel
                 : 0;
  t = std::clamp(t, 0.0, line.length);
  const double share = std::clamp(along.dot(between + t * line.direction) / a, 0.0, 1.0);
  t = std::clamp(line.direction.dot(lower + share * along - line.start), 0.0, line.length);
  return {share, (between + t * line.direction - share * along).norm(), parallel / a};
}

std::vector<NodeAlong> nodesAlong(const Skeleton& skeleton, const Axis& axis) {
  std::vector<NodeAlong> nodes;
  double along = 0;
  for (std::size_t i = 0; i < axis.size(); ++i) {
    if (i > 0) along += (skeleton[axis[i]].position - skeleton[axis[i - 1]].position).norm();
    nodes.push_back({along, axis[i]});
  }
  return nodes;
}

/// Where a branch of station `at` leaves the axis.
Insertion insertionOf(const Skeleton& skeleton, const std::vector<NodeAlong>& nodes, std::size_t at,
                      NodeId branch, const InsertionOptions& options) {
  constexpr double leastWeight = 0.01;
  const auto reach = static_cast<std::size_t>(options.reach);
  Insertion stays{nodes[at].along, leastWeight, {branch}};
  const std::optional<LineBack> line = lineBackFrom(skeleton, branch);
  if (!line) return stays;
  Approach best;
  Insertion result = stays;
  for (std::size_t i = at > reach ? at - reach : 0; i + 1 < nodes.size() && i < at + reach; ++i) {
    const Approach found =
        nearestOn(skeleton[nodes[i].node].position, skeleton[nodes[i + 1].node].position, *line);
    if (found.distance >= best.distance) continue;
    best = found;
    result.along = (1 - found.share) * nodes[i].along + found.share * nodes[i + 1].along;
    result.weight = std::max(leastWeight, found.sharpness);
  }
  const double now = (line->start - skeleton[nodes[at].node].position).norm();
  if (best.distance >= 0.7 * now) return stays; // the line leads past the axis
  const double share = result.weight / (result.weight + options.nodeWeight);
  result.along = stays.along + share * (result.along - stays.along);
  return result;
}

/// Insertions less than `apart` from each other made one, the nearest two first.
void gather(std::vector<Insertion>& insertions, double apart) {
  std::ranges::stable_sort(insertions, {}, &Insertion::along);
  while (insertions.size() > 1) {
    std::size_t nearest = 1;
    const auto gap = [&](std::size_t i) { return insertions[i].along - insertions[i - 1].along; };
    for (std::size_t i = 2; i < insertions.size(); ++i)
      if (gap(i) < gap(nearest)) nearest = i;
    if (!(gap(nearest) < apart)) return;
    Insertion& lower = insertions[nearest - 1];
    const Insertion& upper = insertions[nearest];
    const double share = upper.weight / (lower.weight + upper.weight);
    lower.along += share * (upper.along - lower.along);
    lower.weight += upper.weight;
    lower.branches.insert(lower.branches.end(), upper.branches.begin(), upper.branches.end());
    insertions.erase(insertions.begin() + static_cast<std::ptrdiff_t>(nearest));
  }
}

/// The node at a place of an axis; a new one if none is near.
NodeId nodeAt(Skeleton& skeleton, std::vector<NodeAlong>& nodes, double along, double nearNode) {
  const auto upper = std::ranges::upper_bound(nodes, along, {}, &NodeAlong::along);
  if (upper == nodes.begin()) return nodes.front().node;
  const NodeAlong lower = *(upper - 1);
  if (upper == nodes.end()) return lower.node;
  const double share = (along - lower.along) / (upper->along - lower.along);
  if (share <= nearNode) return lower.node;
  if (share >= 1 - nearNode) return upper->node;
  Node node;
  const Node& above = skeleton[upper->node];
  const Node& below = skeleton[lower.node];
  node.position = below.position + share * (above.position - below.position);
  node.radius = (1 - share) * below.radius + share * above.radius;
  node.parent = lower.node;
  node.edge = above.edge;
  node.origin = above.origin;
  const NodeId added = skeleton.add(node);
  skeleton.reparent(upper->node, added, EdgeType::successor);
  nodes.insert(upper, {along, added});
  return added;
}

} // namespace

Skeleton withSlidInsertions(const Skeleton& skeleton, const InsertionOptions& options) {
  Skeleton result = skeleton;
  for (const Axis& axis : axes(skeleton)) {
    std::vector<NodeAlong> nodes = nodesAlong(skeleton, axis);
    std::vector<Insertion> insertions;
    // What is attached to the end of an axis stays: without it the end would be a tip of its own.
    for (std::size_t at = 0; at + 1 < axis.size(); ++at)
      for (const NodeId child : skeleton.children(axis[at]))
        if (skeleton[child].edge == EdgeType::branching)
          insertions.push_back(insertionOf(skeleton, nodes, at, child, options));
    gather(insertions, options.gather);
    for (const Insertion& insertion : insertions) {
      const NodeId at = nodeAt(result, nodes, insertion.along, options.nearNode);
      for (const NodeId branch : insertion.branches)
        if (result[branch].parent != at) result.reparent(branch, at, EdgeType::branching);
    }
  }
  return result;
}

} // namespace espalier
