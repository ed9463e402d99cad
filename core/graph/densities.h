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

/// What counts as thin and as dense.
struct DensityRange {
  float least = 0;
  float most = 0;
};

/// From the first percentile to the last: single dense spots squeeze nobody. pre: not empty
[[nodiscard]] DensityRange rangeOf(const std::vector<float>& densities);

/// Densities from 0, at the start of the range and below, to 1, at its end and above. 0.5
/// everywhere if these are the same.
[[nodiscard]] std::vector<float> normalizedDensities(const std::vector<float>& densities,
                                                     const DensityRange& range);
/// The same in their own range.
[[nodiscard]] std::vector<float> normalizedDensities(const std::vector<float>& densities);

} // namespace espalier
