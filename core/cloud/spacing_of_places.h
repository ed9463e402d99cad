#pragma once

#include "core/base/spatial_index.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// pointSpacing() of some of the points, no two of them at one place.
///
/// The mean of the distances to the nearest other place, but for those over 16 medians, as strays
/// have them. That is half as much again as the greatest, 10.5, in simulated scans without strays,
/// sparse or dense, with and without noise and leaves. So strays change the mean by their share of
/// the places times 16 medians at most, and not at all if they are farther off.
/// @param index   of the points; neighbors are those that it finds
/// @param places  columns, ascending
[[nodiscard]] double spacingOfPlaces(const Eigen::Matrix3Xf& points, const SpatialIndex& index,
                                     const std::vector<Eigen::Index>& places);

} // namespace espalier
