#pragma once

#include "core/mtg/mtg.h"
#include "core/mtg/mtg_skeleton.h"
#include "core/skeleton/skeleton.h"

namespace espalier {

/// An MTG with what was edited in the skeleton that is a view of it.
///
/// Vertices whose nodes are as skeletonOf(base) has them stay exactly as they are: labels, values
/// as written, order; so do all vertices that are no nodes and have no part in the change, classes,
/// features and rules. If nothing was edited the result equals `base`.
/// - A position that moved is written as the shortest decimals that read back; a radius where the
///   vertex has its own: in radius, or twice in Diameter, else in whichever of them there is.
/// - A removed node leaves. Coarser vertices that have lost their last node leave, and with a
/// vertex
///   all its parts of finer scales. A vertex without position that was attached to a removed one is
///   attached to its nearest ancestor that stays.
/// - A new node is of the class that it carries, else of its parent's, right after its parent; it
///   gets the next free index among the parts of its complex if its class has indices here.
/// - Complexes follow Node::entities; a unit keeps its vertex while its start, or a node that was
///   part of it and carries its entity on, stays. A root lacks no unit (withRootUnits). Parents and
///   edges of units are those of the nodes they start at.
/// - A class or a feature that `base` lacks is declared; a class gets its rules if there are any.
/// - Where scales were added (commitMarks), all that is finer moves: its vertices and its classes.
/// - A vertex without position stays without one where its place still follows from its neighbors.
///
/// pre: ids of `edited` go on from those of skeletonOf(base), as edits leave them
/// - What is made in a plant without positions becomes vertices beside its own.
/// @throws Error if a position or radius is not finite
/// Time O(n log n) for n vertices and nodes.
[[nodiscard]] Mtg withEdits(const Mtg& base, const Skeleton& edited);

/// The same of a view already made: it may be one without nodes, of a base without vertices.
[[nodiscard]] Mtg withEdits(const Mtg& base, const MtgView& view, const Skeleton& edited);

} // namespace espalier
