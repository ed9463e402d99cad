#pragma once

#include "core/skeleton/skeleton_delta.h"

#include <optional>
#include <vector>

namespace espalier {

// How edits keep nodes in the units of an MTG that they are part of (Node::entities). pre, of all:
// the nodes given are contained.

/// Lets the coarser units of a removed node start at those of its children that were part of them.
/// pre: the children are attached where they will be
void passOnUnits(SkeletonEditor& editor, const std::vector<Entity>& entities,
                 const std::vector<NodeId>& children);

/// Attaches `id`, with all it carries, to `parent`, or makes it a root, and leaves it in its units:
/// where it came to them through its old parent, further parts of them start at it. Time O(depth).
/// @throws Error if `parent` is `id` or a descendant of it
void attachInItsUnits(SkeletonEditor& editor, NodeId id, std::optional<NodeId> parent,
                      EdgeType edge = EdgeType::successor);

/// Joins parts of units that start at `id` and say nothing but their name to those of the same name
/// that its parent is part of: what was cut is one again. Units without index are left.
void joinUnitParts(SkeletonEditor& editor, NodeId id);

/// Lets the units along a path start where it is entered once it is walked the other way.
/// @param path each the parent of the next; as it was before its edges are reversed
void reverseUnits(SkeletonEditor& editor, const std::vector<NodeId>& path);

} // namespace espalier
