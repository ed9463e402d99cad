#pragma once

#include "core/base/progress.h"
#include "core/graph/neighborhood_graph.h"

#include <Eigen/Core>

namespace espalier {

struct PathBasedOptions {
  PointLinks neighbors = 7; // of each point
  int rounds = 3;           // >= 0
};

/// Straightens the paths from all points to the root: twigs follow the wood that carries them.
///
/// Shortest paths along the plant make a tree of all points. A point weighs as much as the length
/// of what it carries. Each round finds, by least squares over the whole tree, first directions
/// that agree with the links and, the more the heavier the wood, with those of the parents; then
/// places that keep the middles of the links and give them these directions. Both systems are
/// solved exactly, from the tips to the root and back.
/// Makes wiggling twigs smooth and moves little that is thick: the paths on all sides of a trunk
/// stay.
///
/// @param points 3 x N, finite [L]
/// @param root   column of a point at the foot of the trunk, in [0, N)
/// @return 3 x N, the new place of each point [L]; the root stays
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N k log N).
/// Source: Y. Livny et al., "Automatic reconstruction of tree skeletal structures from point
/// clouds", ACM Trans. Graph. 29(6), 2010, sections 4 and 5. Differs: a point weighs a mean link
/// more than what it carries, not 1, and so knows no unit.
[[nodiscard]] Eigen::Matrix3Xf contractedAlongPaths(const Eigen::Matrix3Xf& points,
                                                    Eigen::Index root,
                                                    const PathBasedOptions& options,
                                                    const Progress& progress = {});

} // namespace espalier
