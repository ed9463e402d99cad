#pragma once

#include "core/skeleton/skeleton.h"

namespace espalier {

/// Sizes of a plant and of what branches from its trunk. Up is z.
struct CrownDimensions {
  double height = 0;     // from the lowest node to the highest [L]
  double baseHeight = 0; // from the lowest node to where the lowest branch leaves [L]
  double depth = 0;      // from there to the highest node [L]
  double area = 0;       // of the convex hull of the branches, seen from above [L^2]
  double diameter = 0;   // of a circle of that area [L]
  double spread = 0;     // greatest horizontal distance between two nodes of branches [L]
};

/// Branches are the nodes of order 1 and above, with the nodes that bear them. A plant without any
/// has a height alone, an empty one nothing. Time O(N log N).
[[nodiscard]] CrownDimensions crownDimensions(const Skeleton& skeleton);

} // namespace espalier
