#pragma once

#include "core/base/progress.h"
#include "core/graph/neighborhood_graph.h"

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

/// A scanned plant seen through one point per cube, and how far these are from its root.
struct ThinnedPlant {
  static constexpr double cubeSide = 2;    // these two in point spacings
  static constexpr double longestLink = 5; // wider gaps are not bridged
  static constexpr int linksPerPoint = 8;
  static constexpr std::size_t dust = 10; // fewer connected points

  std::vector<std::uint32_t> cubeOf; // by point of the scan
  float longest = 0;                 // link [L]
  std::vector<Eigen::Index> points;  // by cube: the first of those in it
  std::vector<Eigen::Index> counts;  // by cube: how many are in it
  Eigen::Matrix3Xf positions;        // of `points`
  NeighborhoodGraph graph;           // of them
  std::vector<bool> isDust;          // by cube
  std::vector<float> distance;       // by cube: from the foot of its part, along links [L]

  [[nodiscard]] bool holds(const NeighborhoodGraph::Link& link) const {
    return link.length <= longest;
  }
};

/// @param spacing of the points [L], > 0
/// @param root    the foot of each part is its point nearest to this; without it, the one farthest
///                from the mean of the part
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N + n log n) for n cubes.
[[nodiscard]] ThinnedPlant thinnedPlant(const Eigen::Matrix3Xf& points, double spacing,
                                        const std::optional<Eigen::Vector3f>& root,
                                        const Progress& progress = {});

/// The ends of a plant: points that none linked to them is farther from the foot than, and from
/// which one has to go back by `shortest` [L] to reach a part that goes on farther. As cubes,
/// ascending. Time O(n log n).
/// Source: the persistence of maxima, H. Edelsbrunner, D. Letscher, A. Zomorodian, Discrete Comput.
/// Geom. 28, 2002.
[[nodiscard]] std::vector<std::uint32_t> endsOf(const ThinnedPlant& plant, double shortest);

/// The plant in pieces: what is connected of each stretch of distance from the foot.
struct PlantPieces {
  static constexpr std::uint32_t none = 0xffffffff;
  std::vector<std::uint32_t> ofCube;                // none for dust
  std::vector<std::vector<std::uint32_t>> adjacent; // by piece: sorted, each once
};

/// @param stretch [L], > 0. Time O(links log links).
[[nodiscard]] PlantPieces piecesOf(const ThinnedPlant& plant, double stretch);

} // namespace espalier
