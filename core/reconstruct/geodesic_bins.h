#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"
#include "core/graph/neighborhood_graph.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

namespace espalier {

struct GeodesicBinOptions {
  PointLinks neighbors = 8; // of each point; more of them bridge wider gaps
  Length binWidth = spacings(0.5) + thicknesses(2.2); // [L] along the plant, > 0
  Length widestGap = 0; // [L] parts of the plant farther apart are not joined; 0 = join all
  double turnCost = 0;  // >= 0; 0: parents follow the shortest paths, else see below
  double ring = 1.5;    // >= 0, bin widths: sides of wood so near become one; see withClosedRings()
};

/// Skeleton of a plant by binning the geodesic distance of its points to the root.
///
/// Links each point to its nearest neighbors, joins what falls apart by the shortest bridges,
/// measures along these links how far each point is from `root`, and makes one node per connected
/// part of each bin, at the centroid of its points. Parents follow the shortest paths over the
/// nodes, or, with a cost of turns, are chosen for all nodes at once: of all trees over neighboring
/// parts that with the least sum of link length * (1 + turnCost * linearity * sin^2 of the angle
/// between the link and the points of the upper part). So a twig that touches another is not taken
/// over by it: the link across costs more than that along, however short the path over it is.
/// First the two sides of a ring of points become one part.
///
/// @param points   3 x N, a column per point [L], finite
/// @param root     column of a point at the foot of the trunk, in [0, N)
/// @return one tree, its root first; all edges are successors (see assembleAxes); radius = mean
///         distance from a node to the points it stands for [L]
/// @throws Error     if over half of the points cannot be reached from `root`
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N k log N), memory O(N k) for k neighbors.
/// Source: H. Xu, N. Gossett, B. Chen, "Knowledge and heuristic-based modeling of laser-scanned
/// trees", ACM Trans. Graph. 26(4), 2007. Differs: twigs missed by the scanner are not invented;
/// the choice of parents by the least sum of costs; rings are closed.
[[nodiscard]] Skeleton skeletonByGeodesicBins(const Eigen::Matrix3Xf& points, Eigen::Index root,
                                              const GeodesicBinOptions& options,
                                              const Progress& progress = {});

} // namespace espalier
