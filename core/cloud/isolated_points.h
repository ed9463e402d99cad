#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"
#include "core/base/spatial_index.h"

#include <vector>

namespace espalier {

struct IsolatedPointOptions {
  static constexpr double usualDistance = 8; // point spacings

  int neighbors = 8; // >= 1
  Length distance = spacings(
      usualDistance); // [L] a point is isolated if these are farther away than this in the mean
};

/// Returns for each point whether it stands alone, as dust, rain and split laser beams do.
///
/// @return one entry per point; none is isolated where there are no more points than neighbors
/// @throws Cancelled if `progress` asks to stop
/// Time O(N k log N).
[[nodiscard]] std::vector<bool> isolatedPoints(const SpatialIndex& points,
                                               const IsolatedPointOptions& options,
                                               const Progress& progress = {});

/// The same for one of the points.
[[nodiscard]] bool isIsolated(const SpatialIndex& points, const Eigen::Vector3f& place,
                              const IsolatedPointOptions& options);

} // namespace espalier
