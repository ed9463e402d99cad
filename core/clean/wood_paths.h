#pragma once

#include "core/base/progress.h"
#include "core/cloud/voxels.h"
#include "core/graph/neighborhood_graph.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace espalier {

/// How thick the wood is at the means of cubes of points [L]: how far the points of the cubes near
/// by scatter across it. Of wood thicker than a cube it is about a cube.
///
/// @param graph  links the means; wood that no links lead to counts for nothing
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N) on all threads.
[[nodiscard]] std::vector<float> woodThickness(const Voxels& voxels, const Eigen::Matrix3Xf& points,
                                               const Eigen::Matrix3Xf& means,
                                               const NeighborhoodGraph& graph,
                                               const Progress& progress = {});

/// The same of wood thicker than a cube, too: where it fills a cube, it is measured over cubes
/// twice as wide, and so on.
///
/// @param thickness  by woodThickness(), at the means of cubes of this edge [L]
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N log N) on all threads.
[[nodiscard]] std::vector<float> fullThickness(std::vector<float> thickness,
                                               const Eigen::Matrix3Xf& means, double edge,
                                               const Progress& progress = {});

/// What makes a path along wood long.
struct WoodPathCosts {
  double power = 2;    // a link costs its length to this, >= 1
  double thinness = 3; // and its length by the thickness of the wood there to this, >= 0
  double turn = 100;   // so many times more where a path turns back, >= 0
};

/// The cheapest paths along wood from `sources`, for each place the next one on its path back; none
/// (core/graph/geodesic.h) at a source and where no path leads.
///
/// Wood gets thinner outwards and goes on straight: a path that leaves a plant by a twig and comes
/// into a branch of another, inwards, is dear. Paths begin upwards, z up. A path knows how it ran
/// over the last ten links, and turns by up to 50 degrees are free.
///
/// @param thickness of the wood at each place [L]
/// @param least     [L] thinner wood counts as this thick, > 0
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O((N + links) log N).
[[nodiscard]] std::vector<std::uint32_t>
woodPaths(const NeighborhoodGraph& graph, const Eigen::Matrix3Xf& places,
          const std::vector<float>& thickness, double least,
          const std::vector<Eigen::Index>& sources, const WoodPathCosts& costs,
          const Progress& progress = {});

} // namespace espalier
