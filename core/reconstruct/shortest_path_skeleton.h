#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"
#include "core/graph/neighborhood_graph.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <numbers>

namespace espalier {

struct ShortestPathOptions {
  PointLinks neighbors = 16;    // of each point
  double power = 2;             // a link costs its length to this power, in [1, 4]
  double leastShare = 0.019;    // of the longest path down, in [0, 1]: less is pruned
  Length spacing = spacings(6); // [L] between nodes, > 0
  double mergeAngle = 25 * std::numbers::pi / 180; // [rad] siblings closer than this may be one
  Length leastRadius = spacings(2); // [L] > 0: how far points lie off the axis even of a twig
  Length thickWood = spacings(1);   // [L] thicker wood is drawn to its axis first; 0 = none
  Length widestGap = 0; // [L] parts of the plant farther apart are not joined; 0 = join all
};

/// Skeleton of a plant from the shortest paths over its points, made simpler, as AdTree does.
///
/// A tree of shortest paths from the root to all points, where many short links are preferred to
/// a leap. Of it go the branches whose longest path is a small share of that of the wood they stand
/// on, and those that end inside this wood. Then, as long as anything changes: siblings that run
/// beside each other within the wood become one, at their mean, weighted by what they carry; where
/// one is shorter, the longer goes on from it; and nodes on a path without branches go that lie
/// within the wood about the line past them. The radius of the wood is measured at the foot and
/// shrinks with the longest path down, to the power 1.1.
///
/// @param points 3 x N, a column per point [L], finite; best contracted
/// @param root   column of a point at the foot of the trunk, in [0, N)
/// @return one tree, its root first; all edges are successors (see assembleAxes); radius = mean
///         distance from a node to the points nearest to it [L]
/// @throws Error     if under half of the points can be reached from `root`
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N k log N), memory O(N k) for k neighbors.
/// Source: S. Du, R. Lindenbergh, H. Ledoux, J. Stoter, L. Nan, "AdTree: accurate, detailed, and
/// automatic modelling of laser-scanned trees", Remote Sensing 11(18), 2019. Differs: near
/// neighbors instead of a Delaunay triangulation (see shortestPathTree); the points of the trunk
/// are centered by contraction, and radii fitted by the steps behind; what ends inside the wood
/// goes, whatever its share; nodes stay at most `spacing` apart instead of being smoothed anew.
[[nodiscard]] Skeleton skeletonByShortestPaths(const Eigen::Matrix3Xf& points, Eigen::Index root,
                                               const ShortestPathOptions& options,
                                               const Progress& progress = {});

} // namespace espalier
