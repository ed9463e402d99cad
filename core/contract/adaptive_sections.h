#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"
#include "core/graph/densities.h"
#include "core/graph/neighborhood_graph.h"

#include <Eigen/Core>

#include <optional>

namespace espalier {

struct AdaptiveSectionOptions {
  PointLinks neighbors = 7;           // of each point
  Length densityRadius = spacings(3); // [L] along the plant, > 0: where points are counted
  // Half of a circumference must be reached: pi times the radii that PlantScan3D looks for.
  Length leastRadius = heights(0.0157); // [L], > 0: where they lie thinnest
  Length mostRadius = heights(0.0628);  // [L], >= leastRadius: where they lie densest
  double curve = 1; // exponent of the density between the two (core/contract/density_radii.h)
  Length width = spacings(1.6);             // [L], > 0: half of the thickness of a section
  Length orientationRadius = heights(0.01); // [L] along the plant: where its direction is measured
  bool fitsCircles = true;                  // for wood seen from one side
  DensityMeasure densityMeasure = DensityMeasure::range;
  std::optional<DensityLevels> densityLevels = {}; // of the scan that the points are a part of
};

/// Contracts a cloud towards the axes of the plant: each point moves to the middle of the
/// cross-section of the wood that it is on.
///
/// The section grows from the point along links between near points, as long as they stay within
/// `width` of it along the wood and within its radius, which grows with the density, across. Where
/// circles are fitted, the center of one takes the place of the mean if the points cover an arc
/// of it (core/contract/circle_center.h).
///
/// @param points 3 x N, finite [L]
/// @return 3 x N, the new place of each point [L]
/// @throws Cancelled if `progress` asks to stop
/// Deterministic; on all threads. Time O(N k m) for m points in a section, and that of the
/// orientations. Source: PlantScan3D's adaptive section contraction, after C. Preuksakarn, PhD
/// thesis, Montpellier 2, 2012, section 4.6.
[[nodiscard]] Eigen::Matrix3Xf contractedToSections(const Eigen::Matrix3Xf& points,
                                                    const AdaptiveSectionOptions& options,
                                                    const Progress& progress = {});

} // namespace espalier
