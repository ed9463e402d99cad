#pragma once

#include "core/base/progress.h"
#include "core/graph/neighborhood_graph.h"
#include "core/graph/neighborhoods.h"

#include <Eigen/Core>

namespace espalier {

/// Normals of the surface that the points sample: for each point, the direction in which it and its
/// neighbors spread least, of either sign.
///
/// @return 3 x N, unit; where the points give no plane, as on a line, one of those across
/// Deterministic; on all threads. @throws Cancelled if `progress` asks to stop
/// Time O(N k). Source: H. Hoppe et al., "Surface reconstruction from unorganized points", SIGGRAPH
/// 1992.
[[nodiscard]] Eigen::Matrix3Xf normals(const Eigen::Matrix3Xf& points,
                                       const Neighborhoods& neighborhoods,
                                       const Progress& progress = {});

/// The same normals, turned so that those of linked points agree.
///
/// From the point of each component that is farthest from its mean, where the normal looks away
/// from the mean, signs are handed on along a minimum spanning tree of weights 1 - |n_i . n_j|.
/// Deterministic. Time O(links log N). @throws Cancelled if `progress` asks to stop
/// Source: as above; it starts at the highest point, which is not the same for a plant that is
/// turned.
[[nodiscard]] Eigen::Matrix3Xf orientedNormals(const Eigen::Matrix3Xf& points,
                                               const Eigen::Matrix3Xf& normals,
                                               const NeighborhoodGraph& graph,
                                               const Progress& progress = {});

} // namespace espalier
