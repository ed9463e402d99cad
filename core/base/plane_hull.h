#pragma once

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// The corners of the convex hull of points in the plane, counterclockwise from the leftmost (the
/// lower of two); the ends of points on a line, the place of points at one.
/// Deterministic; the order of points does not change them. Time O(N log N).
/// Source: Qhull (see core/base/qhull.h).
[[nodiscard]] std::vector<Eigen::Vector2d> planeHull(const std::vector<Eigen::Vector2d>& points);

} // namespace espalier
