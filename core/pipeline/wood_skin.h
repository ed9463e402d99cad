#pragma once

#include "core/skeleton/assign_points.h"
#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier {

/// How far from its axis the bark of each edge reaches [L], by id of its upper end, as the points
/// show it: the radius of a node is that of a circle, and wood is oval and grooved, and measured
/// with errors that may be many point spacings.
///
/// It is the median distance of the points near the edge, and three robust standard deviations
/// (1.48 median absolute deviations) more. Near are those within 1.5 radii and `tolerance`. The
/// radius and `tolerance` is the least, and all there is where fewer than 20 points are near; the
/// most is twice the tolerance over 1.25 medians or radii: new branches that begin there are no
/// bark.
///
/// @param places    where on the skeleton each point is, as assignPoints()
/// @param tolerance [L], from the surface of a frustum: nearer points are explained by it
/// Deterministic. Time O(N + n).
[[nodiscard]] std::vector<double>
barkReaches(const Skeleton& skeleton, const std::vector<PointOnSkeleton>& places, double tolerance);

} // namespace espalier
