#pragma once

#include <Eigen/Core>

#include <array>
#include <optional>
#include <vector>

namespace espalier {

/// The smallest convex body about some points.
struct ConvexHull {
  Eigen::Matrix3Xd corners;                  // [L], frame of the points
  std::vector<std::array<int, 3>> triangles; // corners, counterclockwise as seen from outside
  double volume = 0;                         // [L^3]
  double area = 0;                           // [L^2]
};

/// @param points 3 x N [L]
/// @return none for points that all lie in a plane, on a line or at a place
/// Deterministic; the order of points does not change the body. Time O(N log N).
/// Source: C. B. Barber, D. P. Dobkin, H. Huhdanpaa, "The Quickhull algorithm for convex hulls",
/// ACM Transactions on Mathematical Software 22, 1996 (libqhull).
[[nodiscard]] std::optional<ConvexHull> convexHull(const Eigen::Matrix3Xd& points);

} // namespace espalier
