#pragma once

#include "core/base/rule.h"
#include "core/skeleton/skeleton.h"

namespace espalier {

struct InsertionOptions {
  int reach = 3;         // edges of the parent's axis looked at below and above, >= 1
  double nearNode = 0.3; // share of an edge within which a branch goes to the node there, [0, 0.5]
  double nodeWeight = 1; // of the node that bears a branch, if a line at right angles has 1; >= 0
  Length gather =
      spacings(4); // [L], >= 0: places nearer to each other along the axis are taken for one
};

/// `skeleton` with each branch attached where it comes from: towards where its first edges, drawn
/// on backwards, come nearest to the axis that bears it.
///
/// Methods that follow points attach a branch where its points part from those of the axis: too far
/// up, the more so the narrower its angle. So branches change places with those that leave the axis
/// at wider angles, and what is attached to what is wrong. The line back leads from three edges
/// up the branch through its first node. The flatter it meets the axis the less certain it is, and
/// branches bend near their foot: so a branch goes to the mean of where it is attached, by
/// `nodeWeight`, and where the line leads, by the squared sine of the angle between the two. Nor
/// does a line show the order of branches that leave together, as those of a whorl: places nearer
/// than `gather` become one, their mean by the same squared sines, the nearest first. The branches
/// go to the node near that place, or to a new one on its edge, with a radius in between. One whose
/// line leads past the axis keeps its place, as it does on a node without a continuing axis.
///
/// pre: radii are finite. Positions of nodes do not change, nor does what is attached to which
/// axis.
/// Time O(branches * reach + squared branches of an axis).
[[nodiscard]] Skeleton withSlidInsertions(const Skeleton& skeleton,
                                          const InsertionOptions& options = {});

} // namespace espalier
