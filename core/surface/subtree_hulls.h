#pragma once

#include "core/base/progress.h"
#include "core/skeleton/point_distances.h"
#include "core/surface/convex_hull.h"

#include <optional>
#include <vector>

namespace espalier {

/// The convex hulls of what nodes carry: of the points of the scan that are nearest to the wood of
/// the node or of any node downstream, up to the tips. So leaves, which lie far from all wood,
/// count with the branch they are on.
///
/// @param distances those of `skeleton`
/// @param nodes     of `skeleton`; a hull each, in their order, frame of the file
/// @return none for a node whose points fill no space
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(nodes (skeleton + N log N)) for N points.
[[nodiscard]] std::vector<std::optional<ConvexHull>> subtreeHulls(const PointDistances& distances,
                                                                  const Skeleton& skeleton,
                                                                  const std::vector<NodeId>& nodes,
                                                                  const Progress& progress = {});

} // namespace espalier
