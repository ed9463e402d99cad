#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"
#include "core/graph/neighborhood_graph.h"

#include <Eigen/Core>

namespace espalier {

struct GeodesicCentroidOptions {
  PointLinks neighbors = 7;                       // of each point
  Length radius = spacings(1) + thicknesses(2.6); // [L] along the plant, > 0
  bool fitsCircles = false;                       // for wood seen from one side
};

/// Contracts a cloud towards the axes of the plant: each point moves to the mean of the points that
/// are within `radius` of it along the plant.
///
/// The distance is measured along links between near points, so a neighboring twig does not pull.
/// Tips shrink by about half the radius; the mean of a half cylinder lies 0.64 radii off its axis.
/// Where circles are fitted, the center of one takes the place of the mean if the points run along
/// a line and cover an arc of it (core/contract/circle_center.h).
///
/// @param points 3 x N, finite [L]
/// @return 3 x N, the new place of each point [L]
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N k m / 16) for m points within the radius, memory O(N k).
/// Source: C. Preuksakarn, "Reconstructing plant architecture from 3D laser scanner data",
/// Montpellier 2, 2012, section 4.6.
[[nodiscard]] Eigen::Matrix3Xf contractedToGeodesicCentroids(const Eigen::Matrix3Xf& points,
                                                             const GeodesicCentroidOptions& options,
                                                             const Progress& progress = {});

} // namespace espalier
