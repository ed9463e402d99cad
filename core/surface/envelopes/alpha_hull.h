#pragma once

#include "core/base/rule.h"
#include "core/surface/envelopes/envelope.h"

namespace espalier {

struct AlphaHullOptions {
  Length radius = heights(0.1); // [L] of the ball that is rolled around the crown
  bool fillsHollows = true;     // that no path leads into from outside
};

/// What a ball cannot reach that is rolled around and among the points: the tetrahedra of their
/// Delaunay triangulation whose circumscribed ball is no larger than it.
///
/// Of more than 50 000 points the outermost in each of equal cubes count, so many that no more are
/// left: the cube's side is a parameter then. Pieces that touch at an edge or a corner alone have
/// this edge or corner together.
/// Parameters: radius, pieces, points, and cube, 0 if all points count.
/// @throws Error     if the radius is 0 or less, or so small that there is no body
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N log N) for points spread in space.
/// Source: H. Edelsbrunner, E. P. Muecke, "Three-dimensional alpha shapes", ACM Transactions on
/// Graphics 13, 1994.
[[nodiscard]] Envelope alphaHull(const Crown& crown, const AlphaHullOptions& options = {},
                                 const Progress& progress = {});

} // namespace espalier
