#pragma once

#include "core/base/progress.h"
#include "core/base/spatial_index.h"

#include <vector>

namespace espalier {

struct OutlierOptions {
  int neighbors = 12;    // >= 1
  double deviations = 3; // of the mean distances of all points, >= 0
};

/// For each point whether its neighbors lie farther off in the mean than those of most: by more
/// than so many standard deviations above the mean of all points.
/// @return none of them where there are no more points than neighbors
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N k log N).
/// Source: R. B. Rusu et al., "Towards 3D point cloud based object maps for household
/// environments", Robotics and Autonomous Systems 56, 2008.
[[nodiscard]] std::vector<bool> statisticalOutliers(const SpatialIndex& points,
                                                    const OutlierOptions& options,
                                                    const Progress& progress = {});

struct SparsePointOptions {
  int neighbors = 12;  // >= 1
  double share = 0.01; // of the points that are left out, in [0, 1)
};

/// For each point whether it is one of the share of all that lie thinnest: by the distance to the
/// last of its neighbors.
/// @return no more than that share; those as thin as the first that stays, stay
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N k log N).
[[nodiscard]] std::vector<bool> sparsestPoints(const SpatialIndex& points,
                                               const SparsePointOptions& options,
                                               const Progress& progress = {});

} // namespace espalier
