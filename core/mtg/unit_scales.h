#pragma once

#include "core/mtg/mtg.h"
#include "core/skeleton/skeleton_delta.h"

#include <optional>
#include <string>
#include <vector>

namespace espalier {

// A scale by hand: nodes are marked as starts of units to come, as of annual shoots, then the marks
// become a scale. A mark is Node::isMarked: it is undone and kept in projects as all of a node is,
// and no export knows of it.

/// Whether any node carries entities: what an MTG says of it, and of units that start there.
[[nodiscard]] bool hasEntities(const Skeleton& skeleton);

/// Lets the roots of a skeleton that carries no entities start the units that the first root of
/// `base`, the MTG that it is a view of, starts; without one, plants of nodes as in the MTG that is
/// written of it. One that carries some is left as it is.
void ensureEntities(SkeletonEditor& editor, const Mtg* base = nullptr);

/// Marks nodes; if all of them are marked already, takes their marks off.
void toggleMarks(SkeletonEditor& editor, const std::vector<NodeId>& nodes);
void clearMarks(SkeletonEditor& editor);
[[nodiscard]] std::vector<NodeId> markedNodes(const Skeleton& skeleton);

/// The scale of the entities of nodes; 2, below plants, if none carries any.
[[nodiscard]] int nodeScale(const Skeleton& skeleton);

/// The scales of a skeleton, ascending; that of the nodes is the last. Plants and nodes, 1 and 2,
/// if it carries none.
[[nodiscard]] std::vector<int> scalesOf(const Skeleton& skeleton);

/// The nodes that units begin at if the marks become a scale that is next coarser than `finer`:
/// those marked, roots, and those that a unit of a coarser scale begins at. In the order of axes.
[[nodiscard]] std::vector<NodeId> startsOfNewUnits(const Skeleton& skeleton, int finer);

struct NewScale {
  std::string symbol;       // of its class
  std::optional<int> finer; // the scale it comes directly above; none: that of the nodes
};

/// Makes a scale of the marks, and takes them off.
///
/// Its units begin at startsOfNewUnits(). They are numbered from 1 within each coarser unit, along
/// one axis after the other. The scale gets the number of `finer`; that and all finer ones move
/// down by one. Units of finer scales that go on at a start are cut there, so that units nest. If
/// no node carries anything yet, roots become plants as in the MTG that is written of them.
/// @param base  the MTG that the skeleton is a view of, if any
/// @return how many units there are
/// @throws Error if nothing is marked, the symbol is no symbol or taken, or there are 32 scales
/// pre: scale.finer is in scalesOf()
/// Time O(nodes x scales).
std::size_t commitMarks(SkeletonEditor& editor, const NewScale& scale, const Mtg* base = nullptr);

} // namespace espalier
