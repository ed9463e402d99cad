#pragma once

#include "core/surface/envelopes/envelope.h"

namespace espalier {

struct SkinnedHullOptions {
  int profiles = 24; // around the axis, >= 3
};

/// The hull that is drawn over upright profiles around an axis, from each to the next.
///
/// The axis stands in the middle of the outline from above, between the two sides of the convex
/// hull. Each profile is the convex outline of the points of its sector, by height and by their
/// distance from the axis as a share of how far the outline reaches there; between two profiles
/// that share and the height change evenly with the angle. So it is hollow where a side of the
/// crown has no branches, as a convex hull is not.
/// Parameters: number of profiles, share of the points inside, the two ends of the axis.
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N log N).
/// Source: F. Boudon, thesis, 2004, 2.1; there profiles are curves that are given, and are
/// interpolated by splines.
[[nodiscard]] Envelope skinnedHull(const Crown& crown, const SkinnedHullOptions& options = {},
                                   const Progress& progress = {});

} // namespace espalier
