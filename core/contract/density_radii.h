#pragma once

#include "core/base/progress.h"
#include "core/graph/densities.h"
#include "core/graph/neighborhood_graph.h"

#include <optional>
#include <vector>

namespace espalier {

/// How wide a contraction looks at each point.
struct DensityRadiusOptions {
  double densityRadius = 0; // [L] along the plant, > 0: where points are counted
  double least = 0;         // [L], > 0: where they lie thinnest
  double most = 0;          // [L], >= least: where they lie densest
  double curve = 1;         // exponent of the normalized density between the two, > 0
  DensityMeasure measure = DensityMeasure::range;
  std::optional<DensityLevels> levels = {}; // of the scan that these points are a part of
};

/// The radius for one normalized density [L].
[[nodiscard]] double radiusOfDensity(float density, const DensityRadiusOptions& options);

/// One radius per point [L]: least + (most - least) density^curve. Trunks and main branches, which
/// have the most points, get the greatest; where all is equally dense, the middle one.
///
/// Deterministic; on all threads. @throws Cancelled if `progress` asks to stop
/// Source: C. Preuksakarn, PhD thesis, Montpellier 2, 2012, section 4.6, with a power for the
/// curve.
[[nodiscard]] std::vector<float> densityRadii(const NeighborhoodGraph& graph,
                                              const DensityRadiusOptions& options,
                                              const Progress& progress = {});

} // namespace espalier
