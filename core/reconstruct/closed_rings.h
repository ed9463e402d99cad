#pragma once

#include "core/reconstruct/geodesic_groups.h"

#include <Eigen/Core>

namespace espalier {

/// `groups` with each ring in one piece: the points around thick wood may fall in two sides, as
/// where a scanner saw it from two places, and each would make a line of its own.
///
/// Two groups of one bin become one where their wood parts below and meets again above, at most 12
/// bins on, and nowhere between lies farther apart than `widest`. So branches that touch stay two
/// where they lie apart somewhere.
///
/// @param points  3 x N [L], those that were grouped
/// @param widest  [L] between the centroids of two groups, > 0
/// Deterministic. Time O(N + groups).
[[nodiscard]] GeodesicGroups withClosedRings(GeodesicGroups groups, const Eigen::Matrix3Xf& points,
                                             double widest);

} // namespace espalier
