#include "core/skeleton/assemble_axes.h"

#include "core/skeleton/length_along.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace espalier {
namespace {

/// Length of the edge to each node and of all that is attached to it, by id [L].
std::vector<double> lengthsWithEdges(const Skeleton& skeleton, const std::vector<NodeId>& ids) {
  std::vector<double> lengths = carriedLengths(skeleton);
  for (const NodeId id : ids)
    lengths[indexOf(id)] += edgeLength(skeleton, id);
  return lengths;
}

/// The child that carries most, of those of a node that has some.
NodeId heaviestChild(const std::vector<NodeId>& children, const std::vector<double>& carried) {
  return *std::min_element(children.begin(), children.end(), [&](NodeId a, NodeId b) {
    const double left = carried[indexOf(a)];
    const double right = carried[indexOf(b)];
    return left != right ? left > right : a < b;
  });
}

/// The nodes from a child on, along what carries most, `reach` edges at most.
std::vector<NodeId> pathOn(const Skeleton& skeleton, NodeId child,
                           const std::vector<double>& carried, int reach) {
  std::vector<NodeId> path = {child};
  for (int i = 1; i < reach && !skeleton.children(path.back()).empty(); ++i)
    path.push_back(heaviestChild(skeleton.children(path.back()), carried));
  return path;
}

/// Angle between the directions into a node and out of it to the last of `path`, each over several
/// edges [rad].
double turn(const Skeleton& skeleton, const std::vector<NodeId>& path, int reach) {
  const NodeId node = *skeleton[path.front()].parent;
  NodeId before = node;
  for (int i = 0; i < reach && skeleton[before].parent; ++i)
    before = *skeleton[before].parent;
  const Eigen::Vector3d in = skeleton[node].position - skeleton[before].position;
  const Eigen::Vector3d out = skeleton[path.back()].position - skeleton[node].position;
  return std::atan2(in.cross(out).norm(), in.dot(out)); // 0 at a root
}

/// The middle one of the radii along `path` that are known; 0 if none is.
double radiusAlong(const std::vector<NodeId>& path, const std::vector<double>& radii) {
  std::vector<double> known;
  for (const NodeId id : path)
    if (!radii.empty() && radii[indexOf(id)] > 0) known.push_back(radii[indexOf(id)]);
  if (known.empty()) return 0;
  const auto middle = known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2);
  std::nth_element(known.begin(), middle, known.end());
  return *middle;
}

struct Candidate {
  NodeId child;
  double carried = 0;
  double turn = 0;
  double radius = 0;
};

/// How often the largest value is halved to get a lesser one; no more than 30 times.
double halvings(double value, double largest) {
  return largest > 0 ? std::log2(largest / std::max(value, largest * 0x1p-30)) : 0;
}

/// The one that loses least, unless it turns off too sharply. Where nothing branches, the axis goes
/// on however it turns.
std::optional<NodeId> successorAmong(const std::vector<Candidate>& candidates,
                                     const AxisOptions& options) {
  if (candidates.size() == 1) return candidates.front().child;
  double mostCarried = 0;
  double thickest = 0;
  for (const Candidate& candidate : candidates) {
    mostCarried = std::max(mostCarried, candidate.carried);
    thickest = std::max(thickest, candidate.radius);
  }
  const auto loss = [&](const Candidate& candidate) {
    return options.carried * halvings(candidate.carried, mostCarried) +
           options.straightness * candidate.turn / (std::numbers::pi / 3) +
           (candidate.radius > 0 ? options.thickness * halvings(candidate.radius, thickest) : 0);
  };
  const Candidate* best = nullptr;
  double least = 0;
  for (const Candidate& candidate : candidates) {
    const double own = loss(candidate);
    if (best && (own > least || (own == least && candidate.child > best->child))) continue;
    best = &candidate;
    least = own;
  }
  if (best->turn > options.sharpestTurn) return std::nullopt;
  return best->child;
}

} // namespace

Skeleton withAssembledAxes(const Skeleton& skeleton, const AxisOptions& options,
                           const std::vector<double>& radii) {
  Skeleton result = skeleton;
  const std::vector<NodeId> ids = skeleton.ids();
  const std::vector<double> carried = lengthsWithEdges(skeleton, ids);
  std::vector<Candidate> candidates;
  for (const NodeId id : ids) {
    const std::vector<NodeId>& children = skeleton.children(id);
    if (children.empty()) continue;
    candidates.clear();
    for (const NodeId child : children) {
      const std::vector<NodeId> path = pathOn(skeleton, child, carried, options.reach);
      candidates.push_back({.child = child,
                            .carried = carried[indexOf(child)],
                            .turn = turn(skeleton, path, options.reach),
                            .radius = radiusAlong(path, radii)});
    }
    const std::optional<NodeId> successor = successorAmong(candidates, options);
    for (const NodeId child : children) {
      const EdgeType edge = child == successor ? EdgeType::successor : EdgeType::branching;
      if (skeleton[child].edge != edge) result.setEdge(child, edge);
    }
  }
  return result;
}

} // namespace espalier
