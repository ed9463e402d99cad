#pragma once

#include "core/mtg/mtg_skeleton.h"

#include <set>
#include <utility>

namespace espalier {

/// A skeleton whose roots begin a unit of each scale that they need.
struct RootUnits {
  Skeleton skeleton;
  /// Units that were given to a root, by its node and their scale, and whose class has indices.
  std::set<std::pair<NodeId, int>> toNumber;
};

/// Lets each root of an edited skeleton begin the units that it lacks: no parent hands any on to
/// it, and a vertex of an MTG is part of something coarser.
///
/// They are of the classes that the first root of the view is in. A scale that the view does not
/// have was made by hand, of all of the plant: of it, the class is that of the first unit that
/// begins at a root, else of the first one.
/// Time O(nodes).
[[nodiscard]] RootUnits withRootUnits(const MtgView& view, const Skeleton& edited);

} // namespace espalier
