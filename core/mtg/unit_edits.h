#pragma once

#include "core/mtg/mtg.h"
#include "core/skeleton/skeleton_delta.h"

#include <string>
#include <vector>

namespace espalier {

// Edits of what an MTG says of nodes and of the units that start at them. Each takes what was
// typed, and is refused by an Error of one sentence. `base` is the MTG that the skeleton is a view
// of, none for one that was made here. pre, of all: nodes are
// contained, and some node of the skeleton carries entities.

/// Where what is said of a unit stands: in the entities of the node it starts at.
struct UnitPlace {
  NodeId start{};
  std::size_t entity = 0;
};

/// The units of coarser scales that a node belongs to, coarsest first. Time O(depth).
[[nodiscard]] std::vector<UnitPlace> unitsOf(const Skeleton& skeleton, NodeId id);

/// What is said of the node itself. Time O(nodes).
[[nodiscard]] Entity ownEntity(const Skeleton& skeleton, NodeId id);

/// What is said of the unit of a scale that begins at a node; of the node itself if none does.
/// Time O(nodes).
[[nodiscard]] Entity entityAt(const Skeleton& skeleton, NodeId id, int scale);

/// Lets another unit of a scale begin at a node: of the class of the one that goes on there, with
/// the next free index of this class within the coarser unit if that one has an index. Units of
/// finer scales are cut there.
/// @throws Error if one begins there already
void beginUnit(SkeletonEditor& editor, NodeId id, int scale);

/// Joins what a unit has here to the unit of its scale that the parent belongs to.
/// @throws Error if `id` is a root, no unit of this scale begins there, or one of a coarser scale
/// does
void endUnit(SkeletonEditor& editor, NodeId id, int scale);

/// Changes the class of the entity of a scale that starts at `id`.
/// @throws Error if it is no symbol, or that of a class of another scale
void setClass(SkeletonEditor& editor, NodeId id, int scale, const std::string& symbol,
              const Mtg* base);

/// Changes its index: a whole number from 0 on; empty for none.
/// @throws Error if it is none
void setIndex(SkeletonEditor& editor, NodeId id, int scale, const std::string& index);

/// Changes its name in the file; empty for none.
/// @throws Error if it is no alias (typedAlias), or another entity of the skeleton has it
void setAlias(SkeletonEditor& editor, NodeId id, int scale, const std::string& alias);

} // namespace espalier
