#pragma once

#include "core/base/progress.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace espalier {

/// A tetrahedron between points that has no other point in its circumscribed ball.
struct Tetrahedron {
  std::array<int, 4> corners{};   // points; 1, 2 and 3 turn clockwise as seen from 0
  std::array<int, 4> neighbors{}; // tetrahedra across the side opposite each corner; -1: none
  double radius = 0;              // of the circumscribed ball [L]; infinite if it is flat
};

/// The Delaunay triangulation of points.
///
/// Points are moved by up to 1e-4 of their mean distance first, always alike, so that no five lie
/// on one ball; points at one place are triangulated as neighbors.
/// @param points 3 x N [L], which fill space (see Spread)
/// @throws Error     if Qhull finds none
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N log N) for points spread in space.
/// Source: Qhull (see core/base/qhull.h).
[[nodiscard]] std::vector<Tetrahedron> delaunay(const Eigen::Matrix3Xd& points,
                                                const Progress& progress = {});

} // namespace espalier
