#pragma once

#include "core/base/progress.h"
#include "core/reconstruct/gap_links.h"

namespace espalier {

/// `skeleton` with the gaps in it bridged by direction: a long edge is the shortest path to wood
/// that no scanner saw the foot of, but often not the one it grew.
///
/// Long edges are cut, which leaves fragments; what two nodes stand for, twice their radii, is no
/// gap. Each fragment may be entered at any of its ends, or where it was, from any node of others
/// in reach. A link costs its length, times what the turns at both its ends add, times 1 + half the
/// difference of the logarithms of radii where it joins two tips; and, by `backCost`, the branches
/// that point back in a fragment entered there (see backwardBranches): whole crowns that were
/// entered from above are attached to their feet again. Of all ways to attach the fragments to each
/// other and at last to that of the root, the one with the least sum of costs is taken; fragments
/// are turned around where that enters them elsewhere.
///
/// What no link in reach leads to stays on its long edge. Trees beside the first keep to
/// themselves.
/// pre: radii are finite: what the points of a node lie off it, or 0
/// @return all edges are successors again where they were re-attached (see withAssembledAxes)
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(n log n + ends * nodes in reach).
/// Source of the choice: core/graph/arborescence.h. The costs follow the rule of plants that wood
/// grows on straight; they are this project's.
[[nodiscard]] Skeleton withJoinedGaps(const Skeleton& skeleton, const GapOptions& options,
                                      const Progress& progress = {});

} // namespace espalier
