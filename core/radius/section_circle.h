#pragma once

#include "core/base/circle_fit.h"
#include "core/base/progress.h"
#include "core/radius/cross_section.h"

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace espalier {

/// What a radius is taken from.
enum class RadiusMeasure : std::uint8_t {
  mean,    // mean distance of the points to the node
  maximum, // greatest distance of a point to the node
  hull,    // perimeter of the convex hull / 2 pi, about the centroid of the hull
  circle   // a circle that stray points do not pull
};

/// Why there is no radius.
enum class NoRadius : std::uint8_t {
  noSection, // the node stands alone, or there is no scan
  fewPoints, // under 8
  oneSided,  // the points cover too little of the circle for this measure
  noCircle   // the points lie about no circle: fewer than half of them, or too far off
};

/// A circle about the node or another place of the section; its error and coverage are those of the
/// points that it was taken from: all, or, for RadiusMeasure::circle, those that are not stray.
using MeasuredCircle = std::variant<FittedCircle, NoRadius>;

/// Share of the circle that points must cover for a measure to be trusted, (0, 1].
///
/// Mean and maximum need half, short of a sector: from outside the wood, less of it is seen. The
/// hull of a half circle is 18 % too short, so it needs nearly all; the robust circle needs an arc
/// of about 110 degrees.
[[nodiscard]] double leastCoverage(RadiusMeasure measure);

/// The circle that the points of a section show.
///
/// RadiusMeasure::circle: of circles through three points drawn at random, the one with the least
/// median distance to all, then Taubin's circle through the points within 2.5 standard deviations
/// of it, until these stay the same. Up to half of the points may be stray.
/// Deterministic: the draws are seeded. Time O(m log m) for m points.
/// Source: P. J. Rousseeuw, "Least median of squares regression", JASA 79, 1984; the hull as in
/// PlantScan3D, but about its centroid, not the middle of its box.
[[nodiscard]] MeasuredCircle measuredCircle(const CrossSection& section, RadiusMeasure measure);

/// A circle as long around as the convex hull of the points, about its centroid; none for fewer
/// than 3, or on a line. Time O(m log m).
[[nodiscard]] std::optional<FittedCircle> hullCircle(const std::vector<Eigen::Vector2d>& points);

/// The radii of many nodes.
struct SectionRadii {
  std::vector<std::pair<NodeId, double>> radii; // in the order asked for [L]
  std::array<std::size_t, 4> refused = {};      // nodes without, by NoRadius
};

/// Measures each of `nodes`. pre: contained in the skeleton of `sections`
/// Uses all threads. @throws Cancelled if `progress` asks to stop
[[nodiscard]] SectionRadii sectionRadii(const CrossSections& sections,
                                        const std::vector<NodeId>& nodes, RadiusMeasure measure,
                                        const Progress& progress = {});

} // namespace espalier
