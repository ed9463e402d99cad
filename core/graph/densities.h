#pragma once

#include "core/base/progress.h"
#include "core/base/spatial_index.h"
#include "core/graph/neighborhood_graph.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

// How dense the points lie, per area: a scanner samples surfaces. In 1 / [L^2], but for a factor
// of pi. Deterministic; on all threads. @throws Cancelled if `progress` asks to stop
// Source: C. Preuksakarn, PhD thesis, Montpellier 2, 2012, section 4.5.2.

/// Points within `radius` [L] > 0 along the graph, the center among them, / radius^2.
[[nodiscard]] std::vector<float> radiusDensities(const NeighborhoodGraph& graph, float radius,
                                                 const Progress& progress = {});

/// The `count` nearest others / squared distance of the farthest of them; where these are all at
/// one place, the greatest density elsewhere, 0 if there is none.
[[nodiscard]] std::vector<float> nearestDensities(const SpatialIndex& points, int count,
                                                  const Progress& progress = {});

/// How densities are normalized.
enum class DensityMeasure {
  range, // by their place between the first percentile, 0, and the last, 1: single dense spots
         // squeeze nobody
  rank   // by the share of the points that lie thinner: half of them are below 0.5
};

/// Densities that count as 0, as 1, and evenly between, ascending; two and more.
struct DensityLevels {
  std::vector<float> levels;
};

/// pre: not empty. Time O(N log N)
[[nodiscard]] DensityLevels levelsOf(const std::vector<float>& densities, DensityMeasure measure);

/// Densities from 0, at the first level and below, to 1, at the last and above. 0.5 everywhere if
/// these are the same.
[[nodiscard]] std::vector<float> normalizedDensities(const std::vector<float>& densities,
                                                     const DensityLevels& levels);
/// The same by their own levels.
[[nodiscard]] std::vector<float> normalizedDensities(const std::vector<float>& densities,
                                                     DensityMeasure measure);

} // namespace espalier
