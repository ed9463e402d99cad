#pragma once

#include "core/base/spatial_index.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// [spacings] Wood as thick as this, or thicker, is not told apart by thinWood().
inline constexpr double thickestThinWood = 16;

/// How thick the thin wood of a plant is, as its points show, and how they scatter.
struct ThinWood {
  /// The lower quartile, over points, of the thickness of the wood around them [L]. Noise counts as
  /// thickness. At most thickestThinWood spacings; that much for fewer than 16 places.
  double thickness = 0;
  /// The median, over points, of their standard deviation normal to the surface of the wood [L]. 0
  /// for fewer than 16 places.
  double scatter = 0;
};

/// By what woodAround() sees at some of the places: at 2000 at most in balls up to 8 spacings, and
/// where most of the wood is thicker than 4 of these, at 500 in balls up to 32.
///
/// In simulated scans the thickness lies between 0.95 and 1.3 times the median diameter of the
/// truth, by length, where that is 0.8 to 3 spacings; below 0.5 it is up to twice as much, as fewer
/// points than that show no thickness.
///
/// @param index   of the points; finds those that count
/// @param places  columns to look at, ascending
/// @param spacing of the points [L]
/// Deterministic, on all threads. Time O(1) neighborhoods.
[[nodiscard]] ThinWood thinWood(const Eigen::Matrix3Xf& points, const SpatialIndex& index,
                                const std::vector<Eigen::Index>& places, double spacing);

} // namespace espalier
