#pragma once

#include "core/base/spatial_index.h"

#include <Eigen/Core>

#include <optional>

namespace espalier {

struct ExtendOptions {
  double step = 0;  // [L] how far to go, > 0
  double reach = 0; // [L] points within this of the path belong to the same wood, > 0; a sixth of
                    // the step if that is more
};

/// Where a branch leads from a place: along the points, by one step at most.
///
/// Goes ahead in short stretches; at each it moves to the middle of the points before it and turns
/// with them, so that it follows a bend. It stops where the points end.
/// @param index      of `points`, 3 x N [L]
/// @param from       a place in the frame of the points [L]
/// @param direction  that the branch has there, not zero
/// @return none if points end within a quarter of the step
/// Deterministic. Time O(log N + points met).
[[nodiscard]] std::optional<Eigen::Vector3d>
extendAlong(const SpatialIndex& index, const Eigen::Matrix3Xf& points, const Eigen::Vector3d& from,
            const Eigen::Vector3d& direction, const ExtendOptions& options);

} // namespace espalier
