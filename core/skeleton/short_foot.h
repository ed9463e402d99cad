#pragma once

#include "core/skeleton/check_options.h"
#include "core/skeleton/finding.h"
#include "core/skeleton/point_distances.h"

#include <vector>

namespace espalier {

/// Stems whose points go on below the root, along them and without a gap: by over `footSpacings`
/// spacings and `footRadii` radii.
/// @param spacing between neighboring points [L]
/// @return `amount` is how far the points go on [L], `points` are these
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N log N).
[[nodiscard]] std::vector<Finding> shortFeet(const Skeleton& skeleton,
                                             const PointDistances& distances, double spacing,
                                             const CheckOptions& options,
                                             const Progress& progress = {});

} // namespace espalier
