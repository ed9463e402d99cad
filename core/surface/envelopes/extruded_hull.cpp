#include "core/surface/envelopes/extruded_hull.h"

#include "core/base/plane_hull.h"
#include "core/base/shown.h"
#include "core/surface/envelopes/outline.h"
#include "core/surface/envelopes/rings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace espalier {
namespace {

double widthOf(const ProfileSection& section) {
  return section.to - section.from;
}

/// From the left side of a convex outline to the right one, at a height it has.
ProfileSection sectionAt(const std::vector<Eigen::Vector2d>& corners, double z) {
  ProfileSection section{.z = z,
                         .from = std::numeric_limits<double>::infinity(),
                         .to = -std::numeric_limits<double>::infinity()};
  const auto reach = [&](double x) {
    section.from = std::min(section.from, x);
    section.to = std::max(section.to, x);
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector2d& a = corners[i];
    const Eigen::Vector2d& b = corners[(i + 1) % corners.size()];
    if (z < std::min(a.y(), b.y()) || z > std::max(a.y(), b.y())) continue;
    const double share = a.y() == b.y() ? 0 : (z - a.y()) / (b.y() - a.y());
    reach(a.x() + share * (b.x() - a.x()));
    if (a.y() == b.y()) reach(b.x());
  }
  return section;
}

/// The crown from the side: from where to where it reaches along a level direction, wherever its
/// convex outline bends.
std::vector<ProfileSection> sideOf(const Crown& crown, const Eigen::Vector2d& along) {
  std::vector<Eigen::Vector2d> seen;
  for (const auto& corner : crown.hull.corners.colwise())
    seen.emplace_back(along.dot(corner.head<2>()), corner.z());
  const std::vector<Eigen::Vector2d> corners = planeHull(seen);
  std::set<double> heights;
  for (const Eigen::Vector2d& corner : corners)
    heights.insert(corner.y());
  std::vector<ProfileSection> sections;
  sections.reserve(heights.size());
  for (const double z : heights)
    sections.push_back(sectionAt(corners, z));
  return sections;
}

SurfaceMesh meshOf(const ExtrudedHull& hull) {
  std::vector<Ring> rings;
  for (const ProfileSection& section : hull.side) {
    if (widthOf(section) <= 1e-9 * (hull.ahead + hull.behind)) continue;
    Ring& ring = rings.emplace_back();
    for (const Eigen::Vector2d& corner : hull.outline)
      ring.push_back(placedIn(hull, section, corner));
  }
  return meshOfRings(placedIn(hull, hull.side.front(), hull.middle), rings,
                     placedIn(hull, hull.side.back(), hull.middle));
}

} // namespace

Eigen::Vector3d placedIn(const ExtrudedHull& hull, const ProfileSection& section,
                         const Eigen::Vector2d& place) {
  const double scale = widthOf(section) / (hull.ahead + hull.behind);
  const Eigen::Vector2d from = place - hull.middle;
  const double ahead = hull.along.dot(from);
  const Eigen::Vector2d across = from - ahead * hull.along;
  const Eigen::Vector2d still = hull.middle - hull.along.dot(hull.middle) * hull.along;
  const Eigen::Vector2d at =
      still + scale * across + (section.from + scale * (ahead + hull.behind)) * hull.along;
  return {at.x(), at.y(), section.z};
}

const ProfileSection& widestSection(const ExtrudedHull& hull) {
  return *std::ranges::max_element(hull.side, {}, widthOf);
}

Envelope envelopeOf(const ExtrudedHull& hull) {
  Envelope envelope = envelopeOf(meshOf(hull));
  using Kind = EnvelopeParameter::Kind;
  const auto count = [](std::size_t number) { return static_cast<double>(number); };
  envelope.parameters = {
      {"azimuth", Shown::tr("azimuth of the side profile"), Kind::angle,
       std::atan2(hull.along.y(), hull.along.x())},
      {"outline_ahead", Shown::tr("outline ahead of its middle"), Kind::length, hull.ahead},
      {"outline_behind", Shown::tr("outline behind its middle"), Kind::length, hull.behind},
      {"outline_corners", Shown::tr("corners of the outline"), Kind::number,
       count(hull.outline.size())},
      {"profile_corners", Shown::tr("corners of the side profile"), Kind::number,
       count(2 * hull.side.size())}};
  const double level = widestSection(hull).z;
  addPlace(envelope.parameters, "outline_middle", Shown::tr("middle of the outline"),
           {hull.middle.x(), hull.middle.y(), level});
  envelope.profiles.resize(2);
  for (const Eigen::Vector2d& corner : hull.outline)
    envelope.profiles[0].emplace_back(corner.x(), corner.y(), level);
  const Eigen::Vector2d still = hull.middle - hull.along.dot(hull.middle) * hull.along;
  for (const ProfileSection& section : hull.side)
    for (const double x : {section.from, section.to}) {
      const Eigen::Vector2d at = still + x * hull.along;
      envelope.profiles[1].emplace_back(at.x(), at.y(), section.z);
    }
  return envelope;
}

ExtrudedHull extrudedHullOf(const Envelope& envelope) {
  const double azimuth = valueOf(envelope.parameters, "azimuth");
  ExtrudedHull hull{.along = {std::cos(azimuth), std::sin(azimuth)},
                    .middle = placeOf(envelope.parameters, "outline_middle").head<2>(),
                    .ahead = valueOf(envelope.parameters, "outline_ahead"),
                    .behind = valueOf(envelope.parameters, "outline_behind")};
  for (const Eigen::Vector3d& corner : envelope.profiles[0])
    hull.outline.emplace_back(corner.head<2>());
  const std::vector<Eigen::Vector3d>& side = envelope.profiles[1];
  for (std::size_t i = 0; i + 1 < side.size(); i += 2)
    hull.side.push_back({.z = side[i].z(),
                         .from = hull.along.dot(side[i].head<2>()),
                         .to = hull.along.dot(side[i + 1].head<2>())});
  return hull;
}

Envelope extrudedHull(const Crown& crown, const ExtrudedHullOptions& options,
                      const Progress& progress) {
  const Outline outline = outlineOf(crown);
  Eigen::Vector2d along = boxAround(outline).along;
  if (options.isAcross) along = Eigen::Vector2d(-along.y(), along.x());
  ExtrudedHull hull{.along = along,
                    .middle = outline.middle,
                    .outline = outline.corners,
                    .side = sideOf(crown, along)};
  for (const Eigen::Vector2d& corner : outline.corners) {
    const double ahead = along.dot(corner - outline.middle);
    hull.ahead = std::max(hull.ahead, ahead);
    hull.behind = std::max(hull.behind, -ahead);
  }
  progress.check();
  Envelope envelope = envelopeOf(hull);
  envelope.parameters.push_back({"inside", Shown::tr("share of the points inside"),
                                 EnvelopeParameter::Kind::number,
                                 shareInside(envelope.mesh, crown.points, progress)});
  return envelope;
}

} // namespace espalier
