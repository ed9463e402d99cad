#include "core/surface/envelopes/asymmetric_hull.h"

#include "core/base/shown.h"
#include "core/surface/envelopes/rings.h"

#include <numbers>

namespace espalier {
namespace {

/// The integral of (1 - v^s)^(2/s) over v in [0, 1].
double fullness(double shape) {
  return std::exp(std::lgamma(1 / shape) + std::lgamma(2 / shape + 1) -
                  std::lgamma(3 / shape + 1)) /
         shape;
}

/// A quarter of the widest line.
struct Quarter {
  double alongRadius, acrossRadius; // the latter of the place that stands across
  double alongHeight, acrossHeight;
  double alongSign, acrossSign;
};

std::array<Quarter, 4> quartersOf(const AsymmetricHull& hull) {
  const auto& r = hull.radii;
  const auto& h = hull.heights;
  return {{{r[0], r[1], h[0], h[1], 1, 1},
           {r[2], r[1], h[2], h[1], -1, 1},
           {r[2], r[3], h[2], h[3], -1, -1},
           {r[0], r[3], h[0], h[3], 1, -1}}};
}

/// A level vector along the axes of the hull.
Eigen::Vector2d alongAxes(const AsymmetricHull& hull, const Eigen::Vector2d& level) {
  const double c = std::cos(hull.azimuth);
  const double s = std::sin(hull.azimuth);
  return {c * level.x() + s * level.y(), c * level.y() - s * level.x()};
}

/// The integral over the widest line of its height above `z`, for each area that it sweeps about
/// `from`: half of (P - from) x dP, along the axes.
double sweptAbove(const AsymmetricHull& hull, double z, const Eigen::Vector2d& from) {
  double sum = 0;
  for (const Quarter& q : quartersOf(hull)) {
    const double a = q.alongHeight - z;
    const double b = q.acrossHeight - z;
    const double aboutCenter = q.alongRadius * q.acrossRadius * std::numbers::pi / 4 * (a + b);
    const double offset = from.x() * q.alongSign * q.acrossRadius * (2 * a + b) / 3 +
                          from.y() * q.acrossSign * q.alongRadius * (a + 2 * b) / 3;
    sum += (aboutCenter - offset) / 2;
  }
  return sum;
}

void addParameters(std::vector<EnvelopeParameter>& parameters, const AsymmetricHull& hull) {
  constexpr std::array<const char*, 4> sides = {"ahead", "left", "behind", "right"};
  constexpr std::array<const char*, 4> radii = {Shown::tr("radius ahead"), Shown::tr("radius left"),
                                                Shown::tr("radius behind"),
                                                Shown::tr("radius right")};
  constexpr std::array<const char*, 4> heights = {
      Shown::tr("height ahead"), Shown::tr("height left"), Shown::tr("height behind"),
      Shown::tr("height right")};
  using Kind = EnvelopeParameter::Kind;
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string side = sides[i];
    parameters.push_back({"radius_" + side, radii[i], Kind::length, hull.radii[i]});
  }
  for (std::size_t i = 0; i < 4; ++i) { // above the bottom: a height is no place
    const std::string side = sides[i];
    parameters.push_back(
        {"height_" + side, heights[i], Kind::length, hull.heights[i] - hull.bottom.z()});
  }
  parameters.push_back({"azimuth", Shown::tr("azimuth of ahead"), Kind::angle, hull.azimuth});
  addPlace(parameters, "center", Shown::tr("center"),
           {hull.center.x(), hull.center.y(), hull.bottom.z()});
  addPlace(parameters, "top", Shown::tr("top"), hull.top);
  addPlace(parameters, "bottom", Shown::tr("bottom"), hull.bottom);
  parameters.push_back({"top_shape", Shown::tr("exponent above"), Kind::number, hull.topShape});
  parameters.push_back(
      {"bottom_shape", Shown::tr("exponent below"), Kind::number, hull.bottomShape});
}

} // namespace

double volume(const AsymmetricHull& hull) {
  const auto above = [&](double z, const Eigen::Vector3d& end) {
    return sweptAbove(hull, z, alongAxes(hull, Eigen::Vector2d(end.head<2>()) - hull.center));
  };
  // What is above is measured from level lines that lead from below the top to the widest line,
  // what is below from such lines from above the bottom: they differ by the last term.
  return -fullness(hull.topShape) * above(hull.top.z(), hull.top) +
         fullness(hull.bottomShape) * above(hull.bottom.z(), hull.bottom) +
         above(hull.bottom.z(), hull.top) - above(hull.bottom.z(), hull.bottom);
}

SurfaceMesh meshOf(const AsymmetricHull& hull) {
  std::vector<Eigen::Vector3d> widest;
  const double c = std::cos(hull.azimuth);
  const double s = std::sin(hull.azimuth);
  for (int i = 0; i < ringCorners; ++i) {
    const double angle = 2 * std::numbers::pi * i / ringCorners;
    const std::size_t along = std::cos(angle) >= 0 ? 0 : 2;
    const std::size_t across = std::sin(angle) >= 0 ? 1 : 3;
    const double x = hull.radii[along] * std::cos(angle);
    const double y = hull.radii[across] * std::sin(angle);
    const double share = std::cos(angle) * std::cos(angle);
    widest.emplace_back(hull.center.x() + c * x - s * y, hull.center.y() + s * x + c * y,
                        share * hull.heights[along] + (1 - share) * hull.heights[across]);
  }
  std::vector<Ring> rings;
  constexpr int half = ringLevels / 2;
  const auto addRings = [&](const Eigen::Vector3d& end, double shape, int level) {
    const double angle = std::numbers::pi / 2 * level / half; // from the widest line to the end
    const double out = std::pow(std::cos(angle), 2 / shape);
    const double up = std::pow(std::sin(angle), 2 / shape);
    Ring& ring = rings.emplace_back();
    for (const Eigen::Vector3d& at : widest)
      ring.emplace_back(end.x() + out * (at.x() - end.x()), end.y() + out * (at.y() - end.y()),
                        at.z() + up * (end.z() - at.z()));
  };
  for (int level = half - 1; level > 0; --level)
    addRings(hull.bottom, hull.bottomShape, level);
  rings.push_back(widest);
  for (int level = 1; level < half; ++level)
    addRings(hull.top, hull.topShape, level);
  return meshOfRings(hull.bottom, rings, hull.top);
}

Envelope envelopeOf(const AsymmetricHull& hull) {
  Envelope envelope = envelopeOf(meshOf(hull));
  envelope.volume = volume(hull);
  addParameters(envelope.parameters, hull);
  return envelope;
}

Envelope asymmetricEnvelope(const Crown& crown, const Progress& progress) {
  Envelope envelope = envelopeOf(fitAsymmetricHull(crown, progress.part(0, 0.8)));
  envelope.parameters.push_back({"inside", Shown::tr("share of the points inside"),
                                 EnvelopeParameter::Kind::number,
                                 shareInside(envelope.mesh, crown.points, progress.part(0.8, 1))});
  return envelope;
}

} // namespace espalier
