#pragma once

#include "core/skeleton/skeleton.h"

#include <optional>
#include <unordered_set>
#include <vector>

namespace espalier {

/// What an edit changed: each touched node before and after it. Applying it and its inverse is
/// exact.
struct SkeletonDelta {
  struct Change {
    NodeId id;
    std::optional<Node> before; // none: the edit added the node
    std::optional<Node> after;  // none: the edit removed it

    bool operator==(const Change&) const = default;
  };
  std::vector<Change> changes; // one per node, in order of first touch

  [[nodiscard]] bool isEmpty() const { return changes.empty(); }
  [[nodiscard]] SkeletonDelta inverse() const;

  /// The delta of this edit followed by `next`: a drag of many steps merges into one.
  [[nodiscard]] SkeletonDelta then(const SkeletonDelta& next) const;

  /// Makes `skeleton` what it was after the edit.
  /// pre: each changed node of `skeleton` is as it was before the edit
  void apply(Skeleton& skeleton) const;

  bool operator==(const SkeletonDelta&) const = default;
};

/// Whether a change is of the wood itself: of more than marks, comments and units.
[[nodiscard]] bool changesWood(const SkeletonDelta::Change& change);

/// Edits a skeleton and notes each node before its first change.
///
/// Unless committed, destruction takes the whole edit back: an edit that throws leaves no trace.
///
/// A node that is moved, is attached elsewhere, or has another type of edge is no longer as it was
/// reviewed: unless the same edit changes its mark, it is to do again, as every new node is; its
/// comment stays. Radii are fitted late and for the whole plant: they leave marks as they are.
class SkeletonEditor {
public:
  static constexpr RadiusOrigin byHand = {.source = RadiusSource::byHand};

  explicit SkeletonEditor(Skeleton& skeleton) : skeleton_(skeleton) {}
  ~SkeletonEditor();
  SkeletonEditor(const SkeletonEditor&) = delete;
  SkeletonEditor& operator=(const SkeletonEditor&) = delete;

  [[nodiscard]] const Skeleton& skeleton() const { return skeleton_; }

  // As in Skeleton. @throws Error where a place or radius is not in range (isInRange): nothing may
  // come into a plant that a project could not be read with.
  NodeId add(const Node& node);
  void setPosition(NodeId id, const Eigen::Vector3d& position);
  void setRadius(NodeId id, double radius, const RadiusOrigin& origin = byHand);
  void setEdge(NodeId id, EdgeType edge);
  void setEntities(NodeId id, std::vector<Entity> entities);
  void setMarked(NodeId id, bool isMarked);
  void setReview(NodeId id, ReviewMark review);
  void reparent(NodeId id, NodeId parent, EdgeType edge);
  void makeRoot(NodeId id);
  void erase(NodeId id);

  /// Ends the edit and returns what it changed; nodes that ended as they were are left out.
  [[nodiscard]] SkeletonDelta commit();

private:
  void note(NodeId id);
  void takeBackReviews();
  [[nodiscard]] SkeletonDelta changesSoFar() const;

  Skeleton& skeleton_;
  std::vector<SkeletonDelta::Change> noted_; // `after` is not filled in
  std::unordered_set<std::uint32_t> ids_;    // of noted_
};

} // namespace espalier
