#pragma once

#include "core/base/spatial_index.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// [spacings] Wood as thick as this, or thicker, is not told apart by thinWood().
inline constexpr double thickestThinWood = 4;

/// How thick the thin wood of a plant is, as its points show: the lower quartile, over points, of
/// the thickness of the wood around them [L]. Noise counts as thickness.
///
/// Around a point, balls grow from 2 to 8 spacings until the points in one lie along a line, their
/// second standard deviation at most 0.35 of the first; the wood there is as thick as a ring with
/// the second and third deviations of these points. Wood around which no ball does is
/// thickestThinWood. In simulated scans it lies between 0.95 and 1.3 times the median diameter of
/// the truth, by length, where that is 0.8 to 3 spacings; below 0.5 it is up to twice as much, as
/// fewer points than that show no thickness.
///
/// @param index   of the points; finds those that count
/// @param places  columns to look at, ascending: at most 2000 are, evenly
/// @param spacing of the points [L]
/// @return at most thickestThinWood spacings; that much for fewer than 16 places
/// Deterministic, on all threads. Time O(1) neighborhoods.
[[nodiscard]] double thinWood(const Eigen::Matrix3Xf& points, const SpatialIndex& index,
                              const std::vector<Eigen::Index>& places, double spacing);

} // namespace espalier
