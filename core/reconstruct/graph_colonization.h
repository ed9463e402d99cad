#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"
#include "core/graph/neighborhood_graph.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

struct GraphColonizationOptions {
  PointLinks neighbors = 12;         // of each point; more of them bridge wider gaps
  Length leastStep = spacings(5);    // [L] along the plant where points are sparsest, > 0
  Length greatestStep = spacings(8); // [L] where they are densest, >= leastStep
  double junctionShare = 0; // in [0, 1]: 0 puts a node at the mean of its points, 1 at the mean of
                            // those that touch its parent's, between them on the line between
  Length widestGap = 0;     // [L] parts of the plant farther apart are not joined; 0 = join all
};

/// Skeleton of a plant by colonizing the graph of its points, step by step away from the root.
///
/// As in skeletonByGeodesicBins, nodes are connected groups of points of a range of geodesic
/// distance to the root. But each group decides how far the groups behind it reach, by the density
/// of the points at its end: far in thick wood, which is seen from near, less in twigs. The group
/// that ends nearest to the root grows first, and takes all points within its reach that are
/// connected with it: no other group can take them then. Where the next points lie beyond the
/// reach, across a gap, a group sleeps, as a latent bud does, until the others have come as far.
///
/// @param points    3 x N, a column per point [L], finite
/// @param densities N, in [0, 1] (core/graph/densities.h), of the points as they were scanned
/// @param root      column of a point at the foot of the trunk, in [0, N)
/// @return one tree, its root first; all edges are successors (see assembleAxes); radius = mean
///         distance from a node to the points it stands for [L]
/// @throws Error     if over half of the points cannot be reached from `root`
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N k log N), memory O(N k) for k neighbors.
/// Source: the method of this name in PlantScan3D (INRIA), after C. Preuksakarn, PhD thesis,
/// Montpellier 2, 2012, and H. Xu et al., ACM Trans. Graph. 26(4), 2007.
[[nodiscard]] Skeleton skeletonByGraphColonization(const Eigen::Matrix3Xf& points,
                                                   const std::vector<float>& densities,
                                                   Eigen::Index root,
                                                   const GraphColonizationOptions& options,
                                                   const Progress& progress = {});

} // namespace espalier
