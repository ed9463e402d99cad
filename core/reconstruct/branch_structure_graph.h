#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"
#include "core/graph/neighborhood_graph.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

namespace espalier {

struct BranchStructureOptions {
  PointLinks neighbors = 7; // of each point
  int rounds = 3;           // of straightening, >= 0
  double radiusShare = 1;   // mean radius of the wood, in mean distances of the points from it, > 0
  double leastEdge = 0.15; // in [0, 1]: shorter edges go; 0 = the shortest, 1 = the longest of them
  double overlap = 0.5;    // in (0, 1]: share of the wood of an edge inside another that makes
                           // them one
  Length spacing = spacings(6);   // [L] between nodes at most, > 0
  Length thickWood = spacings(1); // [L] thicker wood is drawn to its axis first; 0 = none
  Length widestGap = 0; // [L] parts of the plant farther apart are not joined; 0 = join all
};

/// Skeleton of a plant by a branch structure graph: a tree over all points, made smooth and simple.
///
/// A tree of shortest paths leads to all points. Each of its edges weighs what it carries. In
/// each round, directions are found that agree with the edges and with each other along the tree,
/// then positions that agree with these directions and with the middles of the edges as they were:
/// heavy branches get straight, and stay in place. Then the tree is filtered: edges that are short
/// among all go; radii follow from what nodes carry, and where the wood of two siblings, or of an
/// edge and the next, overlaps by half, they become one at their weighted mean, again and again.
///
/// @param points 3 x N, a column per point [L], finite
/// @param root   column of a point at the foot of the trunk, in [0, N)
/// @return one tree, its root first; all edges are successors (see assembleAxes); radius = mean
///         distance from a node to the points nearest to it [L]
/// @throws Error     if under half of the points can be reached from `root`
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N k log N), memory O(N k) for k neighbors.
/// Source: Y. Livny et al., "Automatic reconstruction of tree skeletal structures from point
/// clouds", ACM Trans. Graph. 29(6), 2010; the filter is PlantGL's. Both least-squares problems are
/// solved as the paper poses them; on a tree, elimination from the tips does it exactly in O(N).
/// Differs: weights count in mean edges, so that units do not matter; the longest edge that
/// `leastEdge` counts from is that of the 99th percentile: single leaps over gaps are no measure.
[[nodiscard]] Skeleton skeletonByBranchStructure(const Eigen::Matrix3Xf& points, Eigen::Index root,
                                                 const BranchStructureOptions& options,
                                                 const Progress& progress = {});

} // namespace espalier
