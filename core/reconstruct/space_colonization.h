#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"
#include "core/base/spatial_index.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

struct SpaceColonizationOptions {
  Length leastStep = spacings(2); // [L] between nodes where points are sparsest, > 0
  Length greatestStep =
      spacings(3);   // [L] where they are densest, >= leastStep; equal: as Runions has it
  double reach = 4;  // in steps: how far from a node points pull at it, > kill
  double kill = 1.2; // in steps: how near to a node they have done so, > 0
  Length thickWood = spacings(1); // [L] thicker wood is drawn to its axis first; 0 = none
  Length widestGap = 0; // [L] parts of the plant farther apart are not joined; 0 = join all
};

/// Skeleton of a plant by space colonization: points pull the nodes nearest to them.
///
/// Growth starts at the root. In each round each point pulls at the nearest node, if that is within
/// reach; each node that is pulled at gets a child one step off, in the mean direction of its
/// points. Then points near a node are taken away. The steps follow the density of the points,
/// and reach and kill distance with them. All nodes of a round grow at once, so that no order
/// counts. When no node grows, it goes on behind the gaps, at the points nearest to the plant.
///
/// @param points    3 x N, a column per point [L], finite; best contracted
/// @param densities N, in [0, 1] (core/graph/densities.h), of the points as they were scanned
/// @param root      column of a point at the foot of the trunk, in [0, N)
/// @param index     of the same points, if there is one: saves making it
/// @return one tree, its root first; all edges are successors (see assembleAxes); radius = mean
///         distance from a node to the points nearest to it [L]
/// @throws Error     if under half of the points come within reach
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(n (log N + m)) for n nodes and m points in reach of one, memory O(N).
/// Source: A. Runions, B. Lane, P. Prusinkiewicz, "Modeling trees with a space colonization
/// algorithm", Eurographics Workshop on Natural Phenomena, 2007; steps by density: C. Preuksakarn,
/// PhD thesis, Montpellier 2, 2012, section 4.7.1. Differs: gaps are bridged; a node
/// whose points pull it nowhere follows those on the side of the first of them; one whose child
/// would come no nearer to its points stops growing, where the original goes on for ever.
[[nodiscard]] Skeleton
skeletonBySpaceColonization(const Eigen::Matrix3Xf& points, const std::vector<float>& densities,
                            Eigen::Index root, const SpaceColonizationOptions& options,
                            const Progress& progress = {}, const SpatialIndex* index = nullptr);

} // namespace espalier
