#pragma once

#include "core/skeleton/skeleton.h"

namespace espalier {

struct InsertionOptions {
  int reach = 3;         // edges of the parent's axis looked at below and above, >= 1
  double nearNode = 0.3; // share of an edge within which a branch goes to the node there, [0, 0.5]
};

/// `skeleton` with each branch hung where it comes from: where its first edges, drawn on backwards,
/// come nearest to the axis that bears it.
///
/// A method that makes nodes at intervals hangs a branch on the node next to where it leaves, up to
/// half an interval off, and so at a wrong angle. The way back is the line from three edges up the
/// branch to its first node. The branch goes to the node near that place of the axis, or to a new
/// one on its edge, with a radius in between. It stays where its line leads away from the axis, as
/// it does on a node without a continuing axis.
///
/// pre: radii are finite. Positions of nodes do not change, nor does what hangs on which axis.
/// Time O(branches * reach).
[[nodiscard]] Skeleton withSlidInsertions(const Skeleton& skeleton,
                                          const InsertionOptions& options = {});

} // namespace espalier
