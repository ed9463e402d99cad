#pragma once

#include "core/skeleton/skeleton_delta.h"

#include <Eigen/Core>

#include <optional>

namespace espalier {

// Edits by hand, as PlantScan3D's users know them. Each leaves a valid forest with at most one
// successor more per node than it found. pre, of all: each id given is contained.
//
// Nodes stay in the units of an MTG that they are part of, unless the edit is about that: a node
// belongs to the units that start at it and else to those of its parent (Node::entities).

/// The type of edge that a further child of `parent` gets: a successor if it has none yet; `except`
/// does not count as a child.
[[nodiscard]] EdgeType edgeOfNewChild(const Skeleton& skeleton, NodeId parent,
                                      std::optional<NodeId> except = std::nullopt);

void moveNode(SkeletonEditor& editor, NodeId id, const Eigen::Vector3d& position);

/// Moves all nodes by `shift` [L].
void moveAll(SkeletonEditor& editor, const Eigen::Vector3d& shift);

/// Attaches a new node to `parent`, with the radius of `parent`. It continues the axis if `parent`
/// has no successor, else it branches. It joins the units of `parent`.
NodeId addChild(SkeletonEditor& editor, NodeId parent, const Eigen::Vector3d& position);

/// Puts a new node on the edge of `id` to its parent, at `fraction` of it from the parent, in
/// [0, 1]. It takes over the type of the edge and `id` follows it; its radius is interpolated.
/// Units that started at `id` start at it; a mark moves to it.
/// @throws Error if `id` is a root
NodeId splitEdge(SkeletonEditor& editor, NodeId id, double fraction);

/// Removes a node; its children are attached to its parent from then on.
///
/// Its successor takes over its edge, so an axis stays one axis; its other children branch. When a
/// root goes, its successor or only child becomes the root and carries the others; with several
/// children and no successor each becomes a root: which one is the trunk is not for us to guess.
/// Units that started at it start at those of its children that were part of them; a unit that has
/// no other node goes with it. A mark goes on to the first of its children.
void removeNode(SkeletonEditor& editor, NodeId id);

/// Removes a node with all it carries. Any depth.
void removeSubtree(SkeletonEditor& editor, NodeId id);

/// Attaches `id`, with all it carries, to `parent`: as its successor if it has none, else
/// branching. Nothing changes if it is attached there already. Units that start at `id` go with it;
/// for scales where none does, it and what it carries join those of `parent`.
/// @throws Error if `parent` is `id` or a descendant of it
void reparentNode(SkeletonEditor& editor, NodeId id, NodeId parent);

/// Sets the type of the edge to the parent. A new successor makes its siblings branch.
/// @throws Error if `id` is a root
void setEdgeType(SkeletonEditor& editor, NodeId id, EdgeType type);

/// Replaces all nodes by copies of those of `by`, under new ids in the same order: the same ids if
/// the editor's skeleton has never had a node. Time O(N d) for depth d.
void replaceSkeleton(SkeletonEditor& editor, const Skeleton& by);

} // namespace espalier
