#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <numbers>
#include <vector>

namespace espalier {

/// What is clustered where points are dense: directions from a node to its points, or how the wood
/// runs at each of these (core/graph/orientations.h), within the least step along the plant.
enum class ClusteredDirections { toPoints, ofWood };

struct PointTrackingOptions {
  Length leastStep = spacings(5);          // [L] between nodes where points are sparsest, > 0
  Length greatestStep = spacings(6);       // [L] where they are densest, >= leastStep
  double reach = 3;                        // in steps: how far a node sees points, > kill
  double kill = 1;                         // in steps: points nearer to a node are done with, > 0
  double coneAngle = std::numbers::pi / 4; // full opening [rad], in (0, pi / 2)
  int fewestPoints = 3;                    // in a cone that a child grows into, >= 1
  Length thickWood = spacings(1);          // [L] thicker wood is drawn to its axis first; 0 = none
  Length widestGap = 0;        // [L] parts of the plant farther apart are not joined; 0 = join all
  double clusterDensity = 0.5; // in [0, 1]: where points are denser, directions are clustered; 1 =
                               // nowhere
  ClusteredDirections clustered = ClusteredDirections::toPoints;
};

/// Skeleton of a plant by tracking its points from the root up, as the thesis does.
///
/// Each node looks at the points in the shell between the kill distance and its reach, through a
/// cone ahead and rings of cones around it. For each cone with enough points it gets a child, one
/// step off, in the mean direction of those points of the cone that no other node is nearer to.
/// Cones of single twigs' points are not grown into. Where points are dense, and 30 or more are in
/// view, clusters of their directions take the place of cones (core/reconstruct/
/// direction_clusters.h). Steps, reach and kill distance follow the density of the points: far in
/// thick wood, near in twigs. All nodes of a round take away the points near them before any of
/// them looks, so that no order counts. When no node grows, it goes on behind the gaps, at the
/// points nearest to the plant.
///
/// @param points    3 x N, a column per point [L], finite; best contracted
/// @param densities N, in [0, 1] (core/graph/densities.h), of the points as they were scanned
/// @param root      column of a point at the foot of the trunk, in [0, N)
/// @return one tree, its root first; all edges are successors (see assembleAxes); radius = mean
///         distance from a node to the points nearest to it [L]
/// @throws Error     if under half of the points come within reach
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(n (log N + m)) for n nodes and m points in reach of one, memory O(N).
/// Source: C. Preuksakarn, PhD thesis, Montpellier 2, 2012, section 4.7. Differs: gaps are bridged;
/// the first node heads for the points around it, not upwards, so that it may be anywhere; a child
/// that would come no nearer to its points does not grow.
[[nodiscard]] Skeleton skeletonByPointTracking(const Eigen::Matrix3Xf& points,
                                               const std::vector<float>& densities,
                                               Eigen::Index root,
                                               const PointTrackingOptions& options,
                                               const Progress& progress = {});

} // namespace espalier
