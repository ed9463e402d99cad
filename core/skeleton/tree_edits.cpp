#include "core/skeleton/tree_edits.h"

#include "core/base/shown_message.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/keep_units.h"
#include "core/skeleton/select.h"

#include <algorithm>
#include <limits>

namespace espalier {
namespace {

NodeId rootOf(const Skeleton& skeleton, NodeId id) {
  return upstream(skeleton, {id}).back();
}

/// The type of the edge by which a node of a path is attached to the one above it, once
/// it is reversed.
EdgeType reversedEdge(const Skeleton& skeleton, EdgeType before, NodeId newParent) {
  if (edgeOfNewChild(skeleton, newParent) == EdgeType::branching) return EdgeType::branching;
  return skeleton.children(newParent).empty() ? EdgeType::successor : before;
}

/// The nodes of a choice whose parents are not of it, those with a successor edge first, then by
/// id.
std::vector<NodeId> tops(const Skeleton& skeleton, const std::vector<NodeId>& nodes,
                         const std::vector<bool>& isChosen) {
  std::vector<NodeId> result;
  for (const NodeId id : nodes) {
    const std::optional<NodeId>& parent = skeleton[id].parent;
    if (!parent || !isChosen[indexOf(*parent)]) result.push_back(id);
  }
  std::ranges::sort(result, {}, [&](NodeId id) {
    return std::pair(skeleton[id].edge != EdgeType::successor, indexOf(id));
  });
  return result;
}

/// pre: `others` is not empty
NodeId nearestOf(const Skeleton& skeleton, const std::vector<NodeId>& others, NodeId id) {
  NodeId nearest = others.front();
  double least = std::numeric_limits<double>::infinity();
  for (const NodeId other : others) {
    const double distance = (skeleton[other].position - skeleton[id].position).squaredNorm();
    if (distance < least) {
      least = distance;
      nearest = other;
    }
  }
  return nearest;
}

/// From the parent to the node [L]; zero of a root.
Eigen::Vector3d edgeTo(const Skeleton& skeleton, NodeId id) {
  const auto parent = skeleton[id].parent;
  if (!parent) return Eigen::Vector3d::Zero();
  return skeleton[id].position - skeleton[*parent].position;
}

/// Where an axis leads from a node, along some length [L]; zero where it ends there.
Eigen::Vector3d courseFrom(const Skeleton& skeleton, NodeId id, double length) {
  const Eigen::Vector3d& place = skeleton[id].position;
  Eigen::Vector3d course = Eigen::Vector3d::Zero();
  for (auto at = nextOnAxis(skeleton, id); at && course.norm() < length;
       at = nextOnAxis(skeleton, *at))
    course = skeleton[*at].position - place;
  return course;
}

void requireNeighbors(const Skeleton& skeleton, const std::vector<NodeId>& tops) {
  for (const NodeId id : tops) {
    const std::optional<NodeId>& parent = skeleton[id].parent;
    const bool isAlone = tops.size() == 1;
    if (!isAlone && (!parent || parent != skeleton[tops.front()].parent))
      throw ShownError({Shown::tr("node %1 and node %2 are not connected: choose nodes linked by "
                                  "edges, or children of one node"),
                        {std::to_string(indexOf(tops.front())), std::to_string(indexOf(id))}});
  }
}

} // namespace

void swapSuccessor(SkeletonEditor& editor, NodeId id) {
  std::vector<NodeId> children = editor.skeleton().children(id);
  if (children.size() < 2)
    throw ShownError({Shown::tr("node %1 does not branch: choose a node with two children or more"),
                      {std::to_string(indexOf(id))}});
  const bool hasSuccessor = editor.skeleton()[children.front()].edge == EdgeType::successor;
  const NodeId before = children.front();
  std::ranges::sort(children, {}, indexOf);
  auto next = children.begin();
  if (hasSuccessor) next = std::ranges::find(children, before) + 1;
  setEdgeType(editor, next == children.end() ? children.front() : *next, EdgeType::successor);
}

void cutOff(SkeletonEditor& editor, NodeId id) {
  if (!editor.skeleton()[id].parent)
    throw ShownError({Shown::tr("node %1 is a root already: choose a node above it"),
                      {std::to_string(indexOf(id))}});
  attachInItsUnits(editor, id, std::nullopt);
}

std::optional<NodeId> likelyNewParent(const Skeleton& skeleton, const std::vector<NodeId>& nodes) {
  std::vector<NodeId> outside = inverted(skeleton, downstream(skeleton, nodes));
  std::erase_if(outside, [&](NodeId other) {
    return std::ranges::any_of(nodes, [&](NodeId id) { return skeleton[id].parent == other; });
  });
  const Eigen::Vector3d& place = skeleton[nodes.front()].position;
  std::optional<NodeId> best;
  double least = std::numeric_limits<double>::infinity();
  for (const NodeId other : outside) {
    const Eigen::Vector3d edge = place - skeleton[other].position;
    const double length = edge.norm();
    const double near =
        std::max(length - skeleton[other].radius, 0.25 * length); // also within wood
    if (near >= least) continue;
    const Eigen::Vector3d course = courseFrom(skeleton, nodes.front(), 2 * length);
    const double most = length * course.norm();
    const double cosine = most > 0 ? edge.dot(course) / most : 1;
    const Eigen::Vector3d below = edgeTo(skeleton, other);
    const double both = below.norm() * length;
    const double back = both > 0 ? std::max(0.0, -below.dot(edge) / both) : 0;
    const double cost = near * (1 + 2 * (1 - cosine) + 2 * back);
    if (cost >= least) continue;
    least = cost;
    best = other;
  }
  return best;
}

void joinTree(SkeletonEditor& editor, NodeId id, NodeId onto) {
  const Skeleton& skeleton = editor.skeleton();
  if (rootOf(skeleton, id) == rootOf(skeleton, onto))
    throw ShownError(
        {Shown::tr("node %1 and node %2 belong to one tree: reparent one to the other instead"),
         {std::to_string(indexOf(id)), std::to_string(indexOf(onto))}});
  reroot(editor, id);
  editor.reparent(id, onto, edgeOfNewChild(skeleton, onto));
  joinUnitParts(editor, id);
}

NodeId nearestInOtherTree(const Skeleton& skeleton, NodeId id) {
  const std::vector<NodeId> others = inverted(skeleton, treesOf(skeleton, {id}));
  if (others.empty())
    throw ShownError({Shown::tr("the plant is one tree: there is nothing to join node %1 to"),
                      {std::to_string(indexOf(id))}});
  return nearestOf(skeleton, others, id);
}

void reroot(SkeletonEditor& editor, NodeId id) {
  const NodeId root = rootOf(editor.skeleton(), id);
  if (root != id) reversePath(editor, root, id);
}

void reversePath(SkeletonEditor& editor, NodeId top, NodeId bottom) {
  const Skeleton& skeleton = editor.skeleton();
  if (top == bottom || !skeleton.isAncestor(top, bottom))
    throw ShownError(
        {Shown::tr(
             "node %1 does not carry node %2: choose the two ends of a path that leads upward"),
         {std::to_string(indexOf(top)), std::to_string(indexOf(bottom))}});
  const std::vector<NodeId> path = pathBetween(skeleton, top, bottom);
  const Node first = skeleton[top];
  reverseUnits(editor, path);
  std::vector<EdgeType> edges; // to the node before, of all but the first
  for (std::size_t i = 1; i < path.size(); ++i) {
    edges.push_back(skeleton[path[i]].edge);
    editor.makeRoot(path[i]); // all in pieces first: no order of attaching them can make a cycle
  }
  if (first.parent) editor.makeRoot(top);
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
    editor.reparent(path[i], path[i + 1], reversedEdge(skeleton, edges[i], path[i + 1]));
  if (first.parent) editor.reparent(bottom, *first.parent, first.edge);
}

NodeId mergeNodes(SkeletonEditor& editor, const std::vector<NodeId>& nodes) {
  const Skeleton& skeleton = editor.skeleton();
  std::vector<bool> isChosen(skeleton.idEnd(), false);
  for (const NodeId id : nodes)
    isChosen[indexOf(id)] = true;
  if (std::ranges::count(isChosen, true) < 2)
    throw ShownError({Shown::tr("there is one node only: choose two or more to merge")});
  const std::vector<NodeId> highest = tops(skeleton, nodes, isChosen);
  requireNeighbors(skeleton, highest);

  std::vector<NodeId> all; // each once, parents before their children
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double radii = 0;
  int known = 0;
  for (const NodeId id : downstream(skeleton, highest)) {
    if (!isChosen[indexOf(id)]) continue;
    all.push_back(id);
    sum += skeleton[id].position;
    radii += skeleton[id].radius;
    if (skeleton[id].radius > 0) ++known;
  }
  const NodeId kept = highest.front();
  for (const NodeId id : highest)
    if (id != kept) attachInItsUnits(editor, id, kept, edgeOfNewChild(skeleton, kept));
  for (const NodeId id : all)
    if (id != kept) removeNode(editor, id);
  editor.setPosition(kept, sum / static_cast<double>(all.size()));
  if (known > 0) editor.setRadius(kept, radii / known, {.source = RadiusSource::extrapolated});
  return kept;
}

} // namespace espalier
