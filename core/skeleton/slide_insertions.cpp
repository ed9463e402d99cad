#include "core/skeleton/slide_insertions.h"

#include "core/skeleton/axes.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <vector>

namespace espalier {
namespace {

using Eigen::Vector3d;

/// A place on the edge to `upper`, and how near a line comes to it.
struct Insertion {
  NodeId upper{};
  double share = 0; // of the edge, from its lower end
  double distance = std::numeric_limits<double>::infinity();
};

/// The way back from a branch: from its first node, against its direction.
struct WayBack {
  Vector3d start;
  Vector3d direction; // unit
  double length = 0;  // how far it is followed [L]
};

std::optional<WayBack> wayBackFrom(const Skeleton& skeleton, NodeId branch) {
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
  return WayBack{start, back / length, 2 * gap};
}

/// Where a way back comes nearest to an edge.
Insertion nearestOn(const Skeleton& skeleton, NodeId upper, const WayBack& way) {
  const Vector3d& lower = skeleton[*skeleton[upper].parent].position;
  const Vector3d along = skeleton[upper].position - lower;
  const Vector3d between = way.start - lower;
  const double a = along.squaredNorm();
  if (a == 0) return {};
  const double b = along.dot(way.direction);
  const double parallel = a - b * b; // of unit directions: sin^2, times a
  double t = parallel > 1e-9 * a
                 ? (b * along.dot(between) - a * way.direction.dot(between)) / parallel
                 : 0;
  t = std::clamp(t, 0.0, way.length);
  const double share = std::clamp(along.dot(between + t * way.direction) / a, 0.0, 1.0);
  t = std::clamp(way.direction.dot(lower + share * along - way.start), 0.0, way.length);
  const double distance = (between + t * way.direction - share * along).norm();
  return {.upper = upper, .share = share, .distance = distance};
}

/// The edges of the axis through `node`, by their upper ends, nearest first.
std::vector<NodeId> edgesAbout(const Skeleton& skeleton, NodeId node, int reach) {
  std::vector<NodeId> uppers;
  NodeId below = node;
  for (int i = 0; i < reach && skeleton[below].parent; ++i) {
    if (skeleton[below].edge != EdgeType::successor) break; // where the axis begins
    uppers.push_back(below);
    below = *skeleton[below].parent;
  }
  auto above = nextOnAxis(skeleton, node);
  for (int i = 0; i < reach && above; ++i) {
    uppers.push_back(*above);
    above = nextOnAxis(skeleton, *above);
  }
  return uppers;
}

/// The node at a place of an edge; a new one if none is near.
NodeId nodeAt(Skeleton& skeleton, const Insertion& place, double nearNode) {
  const NodeId lower = *skeleton[place.upper].parent;
  if (place.share <= nearNode) return lower;
  if (place.share >= 1 - nearNode) return place.upper;
  Node node;
  const Node& upper = skeleton[place.upper];
  node.position =
      skeleton[lower].position + place.share * (upper.position - skeleton[lower].position);
  node.radius = (1 - place.share) * skeleton[lower].radius + place.share * upper.radius;
  node.parent = lower;
  node.edge = upper.edge;
  const NodeId added = skeleton.add(node);
  skeleton.reparent(place.upper, added, EdgeType::successor);
  return added;
}

} // namespace

Skeleton withSlidInsertions(const Skeleton& skeleton, const InsertionOptions& options) {
  Skeleton result = skeleton;
  for (const NodeId branch : skeleton.ids()) {
    const Node& node = result[branch];
    if (!node.parent || node.edge != EdgeType::branching) continue;
    const NodeId parent = *node.parent;
    const std::optional<WayBack> way = wayBackFrom(result, branch);
    if (!way) continue;
    Insertion best;
    for (const NodeId upper : edgesAbout(result, parent, options.reach)) {
      const Insertion found = nearestOn(result, upper, *way);
      if (found.distance < best.distance) best = found;
    }
    const double now = (way->start - result[parent].position).norm();
    if (best.distance >= 0.7 * now) continue; // the line leads past the axis
    const NodeId at = nodeAt(result, best, options.nearNode);
    if (at != parent) result.reparent(branch, at, EdgeType::branching);
  }
  return result;
}

} // namespace espalier
