#pragma once

#include "core/base/progress.h"
#include "core/radius/cross_section.h"
#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier {

/// How much of the way around the wood at each node the scanner saw, by id, in [0, 1]: the share of
/// 16 sectors about the node that hold points of its section. 0 where there are no points, no node,
/// or no direction.
///
/// About the nodes, not about a circle through the points: the skeleton is taken as true.
/// Uses all threads. Time: see CrossSections. @throws Cancelled if `progress` asks to stop
[[nodiscard]] std::vector<double>
arcCoverages(const Skeleton& skeleton, const IndexedPoints& points, const Progress& progress = {});

} // namespace espalier
