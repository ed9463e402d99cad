#pragma once

#include "core/surface/envelopes/envelope.h"

#include <utility>
#include <vector>

namespace espalier {

struct SkinnedHullOptions {
  int profiles = 24; // around the axis, >= 3
};

/// What a skinned hull is drawn over.
struct SkinnedHull {
  /// Of each place its distance from the axis, as a share of how far the outline reaches there, and
  /// its z [L]. From low to high.
  using Profile = std::vector<Eigen::Vector2d>;

  Eigen::Vector2d middle = Eigen::Vector2d::Zero(); // that the axis goes through [L]
  std::pair<double, double> axis;                   // from, to: z [L]
  double azimuth = 0;                               // of the first profile [rad]
  std::vector<Eigen::Vector2d> outline = {};        // counterclockwise [L]
  std::vector<Profile> profiles = {};               // around the axis, evenly, of one size
};

/// Of each profile.
inline constexpr std::size_t skinnedLevels = 47;

/// Where a profile stands [rad], and how far the outline reaches to there [L].
[[nodiscard]] double azimuthOf(const SkinnedHull& hull, std::size_t profile);
[[nodiscard]] double reachTo(const SkinnedHull& hull, std::size_t profile);

/// The hull as an envelope, and back. pre: the middle is within the outline; 3 profiles or more
[[nodiscard]] Envelope envelopeOf(const SkinnedHull& hull);
[[nodiscard]] SkinnedHull skinnedHullOf(const Envelope& envelope);

/// The hull that is drawn over upright profiles around an axis, from each to the next.
///
/// The axis stands in the middle of the outline from above, between the two sides of the convex
/// hull. Each profile is the convex outline of the points of its sector, by height and by their
/// distance from the axis as a share of how far the outline reaches there; between two profiles
/// that share and the height change evenly with the angle. So it is hollow where a side of the
/// crown has no branches, as a convex hull is not.
/// Parameters: number of profiles, azimuth of the first, the two ends of the axis, share of the
/// points inside.
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N log N).
/// Source: F. Boudon, thesis, 2004, 2.1; there profiles are curves that are given, and are
/// interpolated by splines.
[[nodiscard]] Envelope skinnedHull(const Crown& crown, const SkinnedHullOptions& options = {},
                                   const Progress& progress = {});

} // namespace espalier
