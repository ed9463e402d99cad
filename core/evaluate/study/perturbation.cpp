#include "core/evaluate/study/perturbation.h"

#include "core/base/error.h"
#include "core/base/random.h"
#include "core/base/spatial_index.h"
#include "core/evaluate/match/comparable.h"
#include "core/evaluate/match/segments.h"
#include "core/skeleton/bounds.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <ranges>
#include <sstream>
#include <utility>

namespace espalier {
namespace {

using Eigen::Vector3d;

/// `share` of the elements, in the order in which they are drawn.
template <class Element>
std::vector<Element> drawn(std::vector<Element> from, double share, Random& random) {
  const auto wanted =
      static_cast<std::size_t>(std::llround(share * static_cast<double>(from.size())));
  std::vector<std::pair<double, Element>> lots;
  lots.reserve(from.size());
  for (const Element& element : from)
    lots.emplace_back(random.uniform(), element);
  std::ranges::sort(lots);
  lots.resize(wanted);
  std::vector<Element> result;
  result.reserve(wanted);
  for (const auto& [lot, element] : lots)
    result.push_back(element);
  return result;
}

Skeleton withNoise(Skeleton plant, double sigma, Random& random) {
  for (const NodeId id : plant.ids()) {
    const Vector3d noise(random.normal(), random.normal(), random.normal());
    plant.setPosition(id, plant[id].position + sigma * noise);
  }
  return plant;
}

Skeleton withHeadsMoved(Skeleton plant, double share, Random& random) {
  const std::vector<NodeId> ids = plant.ids();
  const Vector3d origin = plant[ids.front()].position; // floats would blur far frames
  Eigen::Matrix3Xf places(3, static_cast<Eigen::Index>(ids.size()));
  std::vector<NodeId> heads;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    places.col(static_cast<Eigen::Index>(i)) = (plant[ids[i]].position - origin).cast<float>();
    const std::optional<NodeId> parent = plant[ids[i]].parent;
    if (parent && plant.children(*parent).size() > 1) heads.push_back(ids[i]);
  }
  const SpatialIndex index(places);
  for (const NodeId head : drawn(heads, share, random)) {
    const Eigen::Vector3f place = (plant[head].position - origin).cast<float>();
    const auto isOther = [&](Eigen::Index i) {
      const NodeId other = ids[static_cast<std::size_t>(i)];
      return other != plant[head].parent && !plant.isAncestor(head, other);
    };
    const auto found = index.nearestIf(place, std::numeric_limits<float>::max(), isOther);
    if (found)
      plant.reparent(head, ids[static_cast<std::size_t>(found->index)], EdgeType::branching);
  }
  return plant;
}

/// The segments that carry nothing and are attached to something.
std::vector<Segment> terminalSegments(const Skeleton& plant) {
  std::vector<Segment> segments = unbranchedSegments(plant);
  std::erase_if(segments, [&](const Segment& segment) {
    return !segment.parent || !plant.children(segment.nodes.back()).empty();
  });
  return segments;
}

Skeleton pruned(Skeleton plant, double share, Random& random) {
  const std::vector<Segment> terminal = terminalSegments(plant);
  std::vector<std::size_t> all(terminal.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = i;
  for (const std::size_t chosen : drawn(all, share, random)) {
    const std::vector<NodeId>& nodes = terminal[chosen].nodes;
    for (std::size_t i = nodes.size(); i-- > 0;) // children first
      plant.erase(nodes[i]);
  }
  return plant;
}

Skeleton shortened(Skeleton plant, double share) {
  for (const Segment& segment : terminalSegments(plant)) {
    double left = share * segment.length; // still to be cut off
    for (std::size_t i = segment.nodes.size(); i-- > 0;) {
      const NodeId id = segment.nodes[i];
      const Vector3d below = plant[*plant[id].parent].position;
      const double edge = (plant[id].position - below).norm();
      if (edge > left) {
        plant.setPosition(id, below + (1 - left / edge) * (plant[id].position - below));
        break;
      }
      left -= edge;
      plant.erase(id);
    }
  }
  return plant;
}

Skeleton withSpurs(Skeleton plant, double perNode, double length, Random& random) {
  const std::vector<NodeId> ids = plant.ids();
  const auto count = std::llround(perNode * static_cast<double>(ids.size()));
  for (long long i = 0; i < count; ++i) {
    const NodeId foot = ids[random.below(ids.size())];
    const Node& node = plant[foot];
    Vector3d direction = random.direction();
    if (node.parent) { // sideways, so that it is no second axis along the first
      const Vector3d along = (node.position - plant[*node.parent].position).normalized();
      const Vector3d across = direction - direction.dot(along) * along;
      if (across.norm() > 1e-6) direction = across.normalized();
    }
    plant.add({.position = node.position + length * direction,
               .radius = node.radius,
               .parent = foot,
               .edge = EdgeType::branching});
  }
  return plant;
}

/// The unbranched segments, cut where an edge within them begins an axis. Parents come first.
std::vector<std::vector<NodeId>> stretches(const Skeleton& plant) {
  std::vector<std::vector<NodeId>> result;
  for (const Segment& segment : unbranchedSegments(plant))
    for (std::size_t i = 0; i < segment.nodes.size(); ++i) {
      if (i == 0 || plant[segment.nodes[i]].edge == EdgeType::branching) result.emplace_back();
      result.back().push_back(segment.nodes[i]);
    }
  return result;
}

/// Nodes of each stretch evenly along it, about `step` apart; its last node stays, and the root.
Skeleton resampled(const Skeleton& plant, double step) {
  Skeleton result;
  std::vector<NodeId> newOf(plant.idEnd());
  for (const std::vector<NodeId>& stretch : stretches(plant)) {
    const Node& first = plant[stretch.front()];
    std::vector<Node> path; // the nodes that the new ones lie between
    if (first.parent) path.push_back(plant[*first.parent]);
    for (const NodeId id : stretch)
      path.push_back(plant[id]);
    double length = 0;
    for (std::size_t i = 1; i < path.size(); ++i)
      length += (path[i].position - path[i - 1].position).norm();

    std::optional<NodeId> parent;
    if (first.parent) parent = newOf[indexOf(*first.parent)];
    EdgeType edge = first.edge;
    const auto add = [&](const Vector3d& position, double radius) {
      parent = result.add({.position = position, .radius = radius, .parent = parent, .edge = edge});
      edge = EdgeType::successor;
    };
    if (!first.parent) add(first.position, first.radius);
    const double parts = std::max(1.0, std::round(length / step));
    double passed = 0;
    double next = 1; // of the new nodes
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Vector3d edgeVector = path[i].position - path[i - 1].position;
      for (; next < parts && next * length / parts < passed + edgeVector.norm(); ++next) {
        const double share = (next * length / parts - passed) / edgeVector.norm();
        add(path[i - 1].position + share * edgeVector,
            path[i - 1].radius + share * (path[i].radius - path[i - 1].radius));
      }
      passed += edgeVector.norm();
    }
    if (path.size() > 1) add(path.back().position, path.back().radius);
    newOf[indexOf(stretch.back())] = *parent;
  }
  return result;
}

Skeleton turned(Skeleton plant, double angle, Random& random) {
  const Vector3d middle = bounds(plant).center();
  const Eigen::AngleAxisd turn(angle, random.direction());
  for (const NodeId id : plant.ids())
    plant.setPosition(id, middle + turn * (plant[id].position - middle));
  return plant;
}

} // namespace

const std::vector<PerturbationEntry>& perturbations() {
  constexpr double degree = std::numbers::pi / 180;
  static const std::vector<PerturbationEntry> entries = {
      {"position", "median edges", {0.1, 0.3, 0.5, 0.75, 1, 1.5, 2, 3}, 0, 1000},
      {"reparent", "share", {0.02, 0.05, 0.1, 0.2, 0.3, 0.5, 0.75, 1}, 0, 1},
      {"prune", "share", {0.05, 0.1, 0.2, 0.4, 0.6, 0.8}, 0, 1},
      {"shorten", "share", {0.05, 0.1, 0.2, 0.4, 0.6, 0.8}, 0, 1},
      {"spurs", "per node", {0.01, 0.02, 0.05, 0.1, 0.2, 0.5}, 0, 10},
      {"resample", "median edges", {0.25, 0.5, 1, 2, 4}, 0.05, 1e6},
      {"shift", "median edges", {0.1, 0.25, 0.5, 1, 1.5, 2}, 0, 1e6},
      {"turn",
       "radians",
       {0.5 * degree, 1 * degree, 2 * degree, 3 * degree, 5 * degree},
       0,
       2 * std::numbers::pi}};
  return entries;
}

void requireLevel(Perturbation kind, double level) {
  const PerturbationEntry& entry = perturbations()[static_cast<std::size_t>(kind)];
  if (level == 0 || (level >= entry.least && level <= entry.most)) return;
  std::ostringstream text;
  text << "level " << level << " of " << entry.name << ": expected "
       << (entry.least > 0 ? "0, or " : "") << "a number from " << entry.least << " to "
       << entry.most << " (" << entry.unit << ')';
  throw Error(text.str());
}

Skeleton perturbed(const Skeleton& skeleton, Perturbation kind, double level, std::uint64_t seed) {
  requireComparable(skeleton, ComparedAs::reference);
  requireLevel(kind, level);
  if (level == 0) return skeleton;
  Random random(seed);
  const double edge = medianEdgeLength(skeleton);
  switch (kind) {
  case Perturbation::position:
    return withNoise(skeleton, level * edge, random);
  case Perturbation::reparent:
    return withHeadsMoved(skeleton, level, random);
  case Perturbation::prune:
    return pruned(skeleton, level, random);
  case Perturbation::shorten:
    return shortened(skeleton, level);
  case Perturbation::spurs:
    return withSpurs(skeleton, level, edge, random);
  case Perturbation::resample:
    return resampled(skeleton, level * edge);
  case Perturbation::shift: {
    Skeleton plant = skeleton;
    const Vector3d by = level * edge * random.direction();
    for (const NodeId id : plant.ids())
      plant.setPosition(id, plant[id].position + by);
    return plant;
  }
  case Perturbation::turn:
    return turned(skeleton, level, random);
  }
  return skeleton;
}

} // namespace espalier
