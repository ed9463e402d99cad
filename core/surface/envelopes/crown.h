#pragma once

#include "core/base/progress.h"
#include "core/surface/convex_hull.h"

#include <Eigen/Core>

namespace espalier {

/// Points that an envelope is to be fitted to, upright and about a place near them.
struct Crown {
  Eigen::Matrix3Xd points; // [L], z up
  ConvexHull hull;         // of them: what is convex and encloses them needs no other points
};

/// Crown of some points.
///
/// With `within` below 1 the outermost are left out: the corners of the convex hull, then those of
/// the hull of the others and so on, as long as that share of the points stays.
/// @param points 3 x N [L], z up
/// @param within share of the points, in (0, 1]
/// @throws Error     if they are fewer than 4, one is no number, or they fill no space
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N log N) for each hull.
/// Source of the hulls within hulls: V. Barnett, "The ordering of multivariate data", Journal of
/// the Royal Statistical Society A 139, 1976 (convex hull peeling).
[[nodiscard]] Crown crownOf(const Eigen::Matrix3Xd& points, double within = 1,
                            const Progress& progress = {});

/// Lowest and highest z of the crown [L].
[[nodiscard]] double bottomOf(const Crown& crown);
[[nodiscard]] double topOf(const Crown& crown);

} // namespace espalier
