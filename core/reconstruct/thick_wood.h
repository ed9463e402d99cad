#pragma once

#include "core/base/progress.h"
#include "core/graph/neighborhood_graph.h"

#include <Eigen/Core>

namespace espalier {

struct ThickWoodOptions {
  PointLinks neighbors = 12; // of each point
  double radius = 0;         // [L] thicker wood is drawn to its axis; 0 = none is
  double widestGap = 0;      // [L] parts of the plant farther apart are not joined; 0 = join all
};

/// `points` with those of thick wood moved to its axis; the others stay.
///
/// Methods that follow points leave strands on wood so thick that contraction left its points a
/// cylinder. Its axis goes through the middles of the pieces that bins of the distance to the root
/// cut it into, six times as wide as `radius`, and in a second round, of what is thinner than three
/// times that, three times as wide. Wood is as thick as the mean distance of the points of a piece
/// to the axis there.
///
/// @param points 3 x N, a column per point [L], finite; best contracted
/// @param root   column of a point at the foot of the trunk, in [0, N)
/// @throws Error     if over half of the points cannot be reached from `root`
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N k log N), memory O(N k) for k neighbors.
[[nodiscard]] Eigen::Matrix3Xf withThickWoodAsLines(const Eigen::Matrix3Xf& points,
                                                    Eigen::Index root,
                                                    const ThickWoodOptions& options,
                                                    const Progress& progress = {});

} // namespace espalier
