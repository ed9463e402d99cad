#pragma once

#include "core/contract/least_squares_surface.h"

#include <Eigen/Core>

namespace espalier {

struct HoleOptions {
  double widest = 0;  // holes up to this across are filled [L], > 0
  double spacing = 0; // of the points [L], > 0
  double radius = 0;  // of balls that surfaces are fitted in; greater in holes that are wide [L]
};

/// New points in the holes of the surface that `points` sample.
///
/// A hole is a place of the surface about which a circle is empty and that points surround: the
/// circle, whose diameter is over 6 spacings and at most the widest, touches three points that lie
/// on all sides of its middle. Its middle, moved to the surface, is a new point; this goes on until
/// no circle there is over 3 spacings wide. So new points are sparser than others, the edge of a
/// sheet grows by none, and wood that was seen from one side stays open. Where surfaces face each
/// other, or bend by over 45 degrees within the widest hole, they are not joined.
/// @param points  3 x N [L]
/// @return 3 x M, the new ones alone; none is nearer to another point than a spacing
/// Deterministic; on all threads. Time O(N log N) and O(k log k) for each point at a hole that has
/// k points within its width. @throws Cancelled if `progress` asks to stop
/// Source: up-sampling of M. Alexa et al., IEEE TVCG 9(1), 2003, section 4.2, which puts points at
/// corners of Voronoi cells in tangent planes; differs: all holes at once, and no farther than they
/// reach.
[[nodiscard]] Eigen::Matrix3Xf pointsInHoles(const Eigen::Matrix3Xf& points, LocalShape shape,
                                             const HoleOptions& options,
                                             const Progress& progress = {});

} // namespace espalier
