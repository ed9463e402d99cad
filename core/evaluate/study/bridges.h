#pragma once

#include "core/evaluate/study/thinned_plant.h"

namespace espalier {

/// How many places there are where a contraction drew together what is far apart along the plant.
///
/// Two points are drawn together if they come to lie in one cube of a spacing, though the shortest
/// path over pieces of the plant of 4 spacings each is longer than 20 spacings, and than 3 times
/// the distance between them as scanned. Such points make one place with those of the same and of
/// adjacent pieces.
/// @param places  by cube: where its point is contracted to [L]
/// @param spacing of the points [L]
/// Deterministic. Time O(n log n).
[[nodiscard]] Eigen::Index countBridges(const ThinnedPlant& plant, const Eigen::Matrix3Xf& places,
                                        double spacing);

} // namespace espalier
