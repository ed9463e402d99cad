#include "core/evaluate/differences/graft.h"

#include "core/skeleton/edits.h"

#include <algorithm>
#include <cassert>

namespace espalier {
namespace {

/// A place on the edge to a node.
struct Spot {
  NodeId node;
  double share;    // of the edge, from below
  double distance; // from the place looked for [L]
};

Spot spotOn(const Skeleton& skeleton, NodeId id, const Eigen::Vector3d& place) {
  const Node& node = skeleton[id];
  if (!node.parent) return {id, 1, (node.position - place).norm()};
  const Eigen::Vector3d start = skeleton[*node.parent].position;
  const Eigen::Vector3d edge = node.position - start;
  const double squared = edge.squaredNorm();
  const double share = squared > 0 ? std::clamp(edge.dot(place - start) / squared, 0.0, 1.0) : 1;
  return {id, share, (start + share * edge - place).norm()};
}

/// Gives an edge the type of the reference. What else continued the axis there branches.
void setType(SkeletonEditor& editor, NodeId id, EdgeType wanted) {
  if (editor.skeleton()[id].parent && editor.skeleton()[id].edge != wanted)
    setEdgeType(editor, id, wanted);
}

} // namespace

NodeId nodeAt(SkeletonEditor& editor, NodeId host, const Eigen::Vector3d& place, double tolerance,
              std::optional<NodeId> attached) {
  const Skeleton& skeleton = editor.skeleton();
  Spot best = spotOn(skeleton, host, place);
  for (const NodeId child : skeleton.children(host)) {
    if (attached && skeleton.isAncestor(child, *attached)) continue; // the path that is to be left
    if (const Spot spot = spotOn(skeleton, child, place); spot.distance < best.distance)
      best = spot;
  }
  const auto parent = skeleton[best.node].parent;
  if (!parent) return best.node;
  const double length = (skeleton[best.node].position - skeleton[*parent].position).norm();
  if ((1 - best.share) * length <= tolerance) return best.node;
  if (best.share * length <= tolerance) return *parent;
  return splitEdge(editor, best.node, best.share);
}

NodeId nearestIn(const Skeleton& skeleton, const std::vector<NodeId>& roots,
                 const Eigen::Vector3d& place) {
  assert(!roots.empty());
  Spot best = spotOn(skeleton, roots.front(), place);
  std::vector<NodeId> open = roots;
  while (!open.empty()) {
    const NodeId id = open.back();
    open.pop_back();
    if (const Spot spot = spotOn(skeleton, id, place); spot.distance < best.distance) best = spot;
    open.insert(open.end(), skeleton.children(id).begin(), skeleton.children(id).end());
  }
  return best.node;
}

Graft::Graft(SkeletonEditor& editor, const Differences& found, const Skeleton& reference,
             Copied copied)
    : editor_(editor), found_(found), reference_(reference), copied_(copied),
      standing_(editor.skeleton(), found, reference), copies_(reference.idEnd()) {}

bool Graft::carries(NodeId id, std::optional<NodeId> other) const {
  return other && editor_.skeleton().isAncestor(id, *other);
}

void Graft::removeDeadEnd(std::optional<NodeId> end) {
  while (end && editor_.skeleton().children(*end).empty() &&
         indexOf(*end) < found_.ofResult.size() &&
         found_.ofResult[indexOf(*end)] != Difference::matched &&
         found_.standsOn[indexOf(*end)].empty()) {
    const std::optional<NodeId> below = editor_.skeleton()[*end].parent;
    removeNode(editor_, *end);
    end = below;
  }
}

void Graft::attach(NodeId id, NodeId onto, EdgeType edge) {
  const std::optional<NodeId> before = editor_.skeleton()[id].parent;
  if (before == onto) return;
  editor_.reparent(id, onto, EdgeType::branching);
  setType(editor_, id, edge);
  removeDeadEnd(before);
}

void Graft::add(NodeId id, std::optional<NodeId> host) {
  const Node& node = reference_[id];
  Node copy = node;
  if (copied_ == Copied::wood) copy = {.position = node.position, .radius = node.radius};
  copy.parent = host;
  copy.edge = EdgeType::branching;
  added_.push_back(editor_.add(copy)); // to be looked at again, where it is now
  if (!copy.review.comment.empty())
    editor_.setReview(added_.back(), {.comment = copy.review.comment});
  setType(editor_, added_.back(), node.edge);
  copies_[indexOf(id)] = added_.back();
}

void Graft::copy(NodeId id, std::optional<NodeId> host) {
  const Node& node = reference_[id];
  if (!host && node.parent) host = copies_[indexOf(*node.parent)];
  const std::optional<NodeId> there = standing_.lowestOn(id);
  if (there && !carries(*there, host) &&
      (editor_.skeleton()[*there].position - node.position).norm() <= found_.tolerance) {
    if (host) attach(*there, *host, node.edge);
    copies_[indexOf(id)] = there;
    return;
  }
  add(id, host);
}

void Graft::goOnAbove(NodeId id) {
  const NodeId copied = *copies_[indexOf(id)];
  for (const NodeId above : reference_.children(id)) {
    if (copies_[indexOf(above)]) continue;
    for (const NodeId next : standing_.nextAbove(above))
      if (!carries(next, copied)) attach(next, copied, reference_[above].edge);
  }
}

void Graft::attachAlong(NodeId id, const Hold& hold) {
  std::optional<NodeId> onto;
  if (hold.host) onto = nodeAt(editor_, *hold.host, hold.place, found_.tolerance, id);
  for (const NodeId missed : hold.path) {
    if (!copies_[indexOf(missed)]) add(missed, onto);
    onto = copies_[indexOf(missed)];
  }
  if (onto) attach(id, *onto, hold.edge);
}

} // namespace espalier
