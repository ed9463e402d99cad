#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"
#include "core/graph/densities.h"
#include "core/graph/neighborhood_graph.h"

#include <Eigen/Core>

#include <optional>

namespace espalier {

struct AdaptiveGeodesicOptions {
  PointLinks neighbors = 7;           // of each point
  Length densityRadius = spacings(3); // [L] along the plant, > 0: where points are counted
  Length leastRadius = spacings(5);   // [L], > 0: where they lie thinnest
  Length mostRadius = spacings(10);   // [L], >= leastRadius: where they lie densest
  double curve = 1;  // exponent of the density between the two (core/contract/density_radii.h)
  double along = 1;  // weight of squared lengths along the wood, >= 0
  double across = 1; // and across it, >= 0; not both 0
  Length orientationRadius = heights(0.01); // [L] along the plant: where its direction is measured
  bool fitsCircles = true;                  // for wood seen from one side
  DensityMeasure densityMeasure = DensityMeasure::range;
  std::optional<DensityLevels> densityLevels = {}; // of the scan that the points are a part of
};

/// Contracts a cloud towards the axes of the plant: each point moves to the mean of the points near
/// it along the plant, within a radius that grows with their density.
///
/// With weights other than 1 the ball about a point is stretched: a link costs
/// sqrt(along a^2 + across b^2), a along the direction of the plant at that point, b across. More
/// weight along makes it a slice of the wood, more across a piece of a cylinder.
/// Where circles are fitted, the center of one takes the place of the mean if the points run along
/// a line and cover an arc of it (core/contract/circle_center.h).
///
/// @param points 3 x N, finite [L]
/// @return 3 x N, the new place of each point [L]
/// @throws Error     if both weights are 0
/// @throws Cancelled if `progress` asks to stop
/// Deterministic; on all threads. Time O(N k m / 16) for m points within the radius.
/// Source: C. Preuksakarn, "Reconstructing plant architecture from 3D laser scanner data",
/// Montpellier 2, 2012, section 4.6.
[[nodiscard]] Eigen::Matrix3Xf contractedAdaptively(const Eigen::Matrix3Xf& points,
                                                    const AdaptiveGeodesicOptions& options,
                                                    const Progress& progress = {});

} // namespace espalier
