#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"
#include "core/graph/neighborhood_graph.h"

#include <Eigen/Core>

namespace espalier {

struct RotationalSymmetryOptions {
  PointLinks neighbors = 7;   // of each point
  int normalNeighbors = 12;   // points that give a normal, >= 3
  Length width = spacings(2); // [L], > 0: half of the thickness of a section
  Length reach = spacings(8); // [L], > 0: how far it goes across
  int rounds = 3;             // >= 1: how often axes are found
  int smoothing = 5;          // >= 0: how often unknown places follow their neighbors
};

/// Contracts a cloud to its rotational symmetry axes, for wood of which parts are not seen.
///
/// The axis at a point is the direction that the normals of its section keep the same angle to:
/// that of the least variance. Section and axis are found in turn, and axes smoothed along the
/// graph. The point then moves to the place that the lines along these normals pass nearest to,
/// which on a round stem is its middle, whatever part of the round the scanner saw. Where they pass
/// no place together, as on forks and flat pieces, it follows its linked neighbors.
/// Needs normals, which twigs of one or two spacings hardly have.
///
/// @param points 3 x N, finite [L]
/// @return 3 x N, the new place of each point [L]
/// @throws Cancelled if `progress` asks to stop
/// Deterministic; on all threads. Time O(N (rounds k m + log N)) for m points in a section.
/// Source: A. Tagliasacchi, H. Zhang, D. Cohen-Or, "Curve skeleton extraction from incomplete point
/// cloud", ACM Trans. Graph. 28(3), 2009. Differs: the skeleton is not thinned to lines by moving
/// least squares, as places of points are wanted.
[[nodiscard]] Eigen::Matrix3Xf contractedToSymmetryAxes(const Eigen::Matrix3Xf& points,
                                                        const RotationalSymmetryOptions& options,
                                                        const Progress& progress = {});

} // namespace espalier
