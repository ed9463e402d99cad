#include "core/skeleton/skeleton_delta.h"

#include "core/base/coordinates.h"

#include <cassert>
#include <unordered_map>
#include <utility>

namespace espalier {
namespace {

ShownError outOfRange(NodeId id) {
  return ShownError(
      {Shown::tr("node %1: its place or radius is beyond 1e12, as of no plant: correct "
                 "or remove it"),
       {std::to_string(indexOf(id))}});
}

std::optional<Node> lookUp(const Skeleton& skeleton, NodeId id) {
  if (!skeleton.contains(id)) return std::nullopt;
  return skeleton[id];
}

/// Whether an edit left a node, and its edge to the parent, as they were when they were looked at.
bool looksAlike(const Node& a, const Node& b) {
  return a.position == b.position && a.parent == b.parent && (!a.parent || a.edge == b.edge);
}

/// What became of the nodes noted; those that ended as they were are left out.
SkeletonDelta deltaOf(std::vector<SkeletonDelta::Change> noted, const Skeleton& skeleton) {
  for (SkeletonDelta::Change& change : noted)
    change.after = lookUp(skeleton, change.id);
  std::erase_if(noted, [](const SkeletonDelta::Change& c) { return c.before == c.after; });
  return {std::move(noted)};
}

} // namespace

SkeletonDelta SkeletonDelta::inverse() const {
  SkeletonDelta result;
  result.changes.reserve(changes.size());
  for (const Change& change : changes)
    result.changes.push_back({change.id, change.after, change.before});
  return result;
}

SkeletonDelta SkeletonDelta::then(const SkeletonDelta& next) const {
  SkeletonDelta result = *this;
  std::unordered_map<std::uint32_t, std::size_t> places;
  for (std::size_t i = 0; i < changes.size(); ++i)
    places.emplace(static_cast<std::uint32_t>(changes[i].id), i);
  for (const Change& change : next.changes) {
    const auto [place, isNew] =
        places.emplace(static_cast<std::uint32_t>(change.id), result.changes.size());
    if (isNew)
      result.changes.push_back(change);
    else
      result.changes[place->second].after = change.after;
  }
  std::erase_if(result.changes, [](const Change& c) { return c.before == c.after; });
  return result;
}

void SkeletonDelta::apply(Skeleton& skeleton) const {
  // Cut every changed link first: then no order of the changes can meet a missing parent, a cycle,
  // or a removed node that still has children.
  for (const Change& change : changes)
    if (change.before) {
      assert(skeleton.contains(change.id) && skeleton[change.id] == *change.before);
      skeleton.makeRoot(change.id);
    }
  for (const Change& change : changes) {
    if (change.before && !change.after) skeleton.erase(change.id);
    if (!change.before) {
      Node alone = *change.after;
      alone.parent.reset();
      skeleton.restore(change.id, alone);
    }
  }
  for (const Change& change : changes) {
    if (!change.after) continue;
    skeleton.setPosition(change.id, change.after->position);
    skeleton.setRadius(change.id, change.after->radius, change.after->origin);
    skeleton.setEntities(change.id, change.after->entities);
    skeleton.setMarked(change.id, change.after->isMarked);
    skeleton.setReview(change.id, change.after->review);
    if (change.after->parent)
      skeleton.reparent(change.id, *change.after->parent, change.after->edge);
    else
      skeleton.setEdge(change.id, change.after->edge);
  }
}

SkeletonEditor::~SkeletonEditor() {
  if (!noted_.empty()) changesSoFar().inverse().apply(skeleton_);
}

NodeId SkeletonEditor::add(const Node& node) {
  if (!isInRange(node.position, node.radius))
    throw ShownError(
        {espalier::Shown::tr("a new node: its place or radius is beyond 1e12, as of no "
                             "plant: correct or remove it")});
  const NodeId id = skeleton_.add(node);
  skeleton_.setReview(id, {}); // of a copy, too
  ids_.insert(static_cast<std::uint32_t>(id));
  noted_.push_back({id, std::nullopt, std::nullopt});
  return id;
}

void SkeletonEditor::setPosition(NodeId id, const Eigen::Vector3d& position) {
  if (!isInRange(position)) throw outOfRange(id);
  note(id);
  skeleton_.setPosition(id, position);
}

void SkeletonEditor::setRadius(NodeId id, double radius, const RadiusOrigin& origin) {
  if (!(radius <= largestCoordinate)) throw outOfRange(id);
  note(id);
  skeleton_.setRadius(id, radius, origin);
}

void SkeletonEditor::setEdge(NodeId id, EdgeType edge) {
  note(id);
  skeleton_.setEdge(id, edge);
}

void SkeletonEditor::setEntities(NodeId id, std::vector<Entity> entities) {
  note(id);
  skeleton_.setEntities(id, std::move(entities));
}

void SkeletonEditor::setMarked(NodeId id, bool isMarked) {
  note(id);
  skeleton_.setMarked(id, isMarked);
}

void SkeletonEditor::setReview(NodeId id, ReviewMark review) {
  note(id);
  skeleton_.setReview(id, std::move(review));
}

void SkeletonEditor::reparent(NodeId id, NodeId parent, EdgeType edge) {
  note(id);
  skeleton_.reparent(id, parent, edge);
}

void SkeletonEditor::makeRoot(NodeId id) {
  note(id);
  skeleton_.makeRoot(id);
}

void SkeletonEditor::erase(NodeId id) {
  note(id);
  skeleton_.erase(id);
}

bool changesWood(const SkeletonDelta::Change& change) {
  if (!change.before || !change.after) return true;
  const Node& a = *change.before;
  const Node& b = *change.after;
  return a.position != b.position || a.radius != b.radius || a.parent != b.parent ||
         a.edge != b.edge;
}

SkeletonDelta SkeletonEditor::commit() {
  takeBackReviews();
  SkeletonDelta delta = deltaOf(std::move(noted_), skeleton_);
  noted_.clear();
  ids_.clear();
  return delta;
}

void SkeletonEditor::note(NodeId id) {
  if (!ids_.insert(static_cast<std::uint32_t>(id)).second) return;
  noted_.push_back({id, skeleton_[id], std::nullopt});
}

void SkeletonEditor::takeBackReviews() {
  for (const SkeletonDelta::Change& change : noted_) {
    if (!change.before || !skeleton_.contains(change.id)) continue;
    const Node& after = skeleton_[change.id];
    const bool isStale = after.review == change.before->review &&
                         after.review.state == ReviewState::reviewed &&
                         !looksAlike(after, *change.before);
    if (isStale) skeleton_.setReview(change.id, {.comment = after.review.comment});
  }
}

SkeletonDelta SkeletonEditor::changesSoFar() const {
  return deltaOf(noted_, skeleton_);
}

} // namespace espalier
