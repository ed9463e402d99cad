#pragma once

#include "core/surface/envelopes/envelope.h"

#include <vector>

namespace espalier {

struct ExtrudedHullOptions {
  bool isAcross = false; // the vertical profile is that seen along the outline's length
};

/// A level section of a side profile.
struct ProfileSection {
  double z = 0;    // [L]
  double from = 0; // its two sides, along the plane of the profile [L]
  double to = 0;
};

/// What an extruded hull is made of: an outline from above, and a profile from the side.
struct ExtrudedHull {
  Eigen::Vector2d along = Eigen::Vector2d::UnitX(); // level, of the plane of the side profile
  Eigen::Vector2d middle = Eigen::Vector2d::Zero(); // within the outline [L]
  double ahead = 0;                                 // how far the outline reaches along it and
  double behind = 0;                                // back, from the middle [L]
  std::vector<Eigen::Vector2d> outline = {};        // counterclockwise [L]
  std::vector<ProfileSection> side = {};            // from the lowest to the highest
};

/// Where a place of the outline comes to stand in a section.
[[nodiscard]] Eigen::Vector3d placedIn(const ExtrudedHull& hull, const ProfileSection& section,
                                       const Eigen::Vector2d& place);
[[nodiscard]] const ProfileSection& widestSection(const ExtrudedHull& hull);

/// The hull as an envelope, and back. pre: there are an outline and two sections, one of them wide
[[nodiscard]] Envelope envelopeOf(const ExtrudedHull& hull);
[[nodiscard]] ExtrudedHull extrudedHullOf(const Envelope& envelope);

/// The hull that a horizontal profile sweeps along a vertical one: at each height it is as wide as
/// the vertical profile there, and keeps its form.
///
/// The horizontal profile is the convex outline of the crown from above, the vertical one that from
/// the side: across it the outline is longest, or widest if `isAcross`. Both are drawn through the
/// extreme points; the crown is in it where each of its sections is as its outline.
/// Parameters: azimuth of the plane of the vertical profile, how far the outline reaches along it,
/// how many corners each profile has, the middle of the outline, share of the points inside.
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(corners log corners + mesh) and that of shareInside() for all points.
/// Source: P. Birnbaum, "Modalites d'occupation de l'espace par les arbres en foret guyanaise",
/// thesis, 1997, as in F. Boudon, thesis, 2004, 2.1.
[[nodiscard]] Envelope extrudedHull(const Crown& crown, const ExtrudedHullOptions& options = {},
                                    const Progress& progress = {});

} // namespace espalier
