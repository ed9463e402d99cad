#include "core/surface/envelopes/simple_solid.h"

#include "core/base/shown.h"
#include "core/surface/envelopes/box_envelope.h"
#include "core/surface/envelopes/enclosing_ball.h"
#include "core/surface/envelopes/enclosing_ellipsoid.h"
#include "core/surface/envelopes/solids_of_revolution.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

namespace espalier {
namespace {

using Kind = SimpleSolid::Kind;
using Eigen::Vector3d;

constexpr const char* centerHandle = "center";
constexpr const char* topHandle = "top";
constexpr const char* bottomHandle = "bottom";

/// How far a solid reaches, as one of its parameters.
struct Reach {
  std::string name;  // of the parameter and the handle
  std::string label; // to people
  double share = 1;  // of the parameter
  double level = 0;  // of the handle, from its foot (0) to its top (1)
  int direction = 0; // which of those of the solid
};

std::vector<Reach> reachesOf(Kind kind) {
  switch (kind) {
  case Kind::ellipsoid:
    return {{"semi_axis_a", Shown::tr("semi-axis a")},
            {"semi_axis_b", Shown::tr("semi-axis b"), 1, 0, 1},
            {"semi_axis_c", Shown::tr("semi-axis c"), 1, 0, 2}};
  case Kind::cylinder:
    return {{"radius", Shown::tr("radius"), 1, 0.5}};
  case Kind::frustum:
    return {{"bottom_radius", Shown::tr("bottom radius")},
            {"top_radius", Shown::tr("top radius"), 1, 1}};
  case Kind::box:
    return {{"length", Shown::tr("length"), 0.5, 0.5}, {"width", Shown::tr("width"), 0.5, 0.5, 1}};
  default:
    return {{"radius", Shown::tr("radius")}};
  }
}

bool isUpright(Kind kind) {
  return kind != Kind::ball && kind != Kind::ellipsoid;
}

std::optional<std::size_t> reachNamed(const std::vector<Reach>& reaches, const std::string& name) {
  const auto found = std::ranges::find(reaches, name, &Reach::name);
  if (found == reaches.end()) return std::nullopt;
  return static_cast<std::size_t>(found - reaches.begin());
}

/// What a handle is measured from.
Vector3d middleOf(const SimpleSolid& solid, double level) {
  if (!isUpright(solid.kind)) return solid.center;
  return {solid.center.x(), solid.center.y(), std::lerp(solid.bottom, solid.top, level)};
}

/// Less than this would be no solid.
double thinnest(const SimpleSolid& solid) {
  return 1e-3 * std::max(*std::ranges::max_element(solid.reaches), solid.top - solid.bottom);
}

} // namespace

SimpleSolid simpleSolidOf(Kind kind, const Envelope& envelope) {
  const auto value = [&](const std::string& name) { return valueOf(envelope.parameters, name); };
  SimpleSolid solid{.kind = kind, .directions = envelope.directions};
  const std::vector<Reach> reaches = reachesOf(kind);
  for (std::size_t i = 0; i < reaches.size(); ++i)
    solid.reaches[i] = reaches[i].share * value(reaches[i].name);
  if (kind == Kind::box) {
    const double azimuth = value("azimuth");
    solid.directions.col(0) = Vector3d(std::cos(azimuth), std::sin(azimuth), 0);
    solid.directions.col(1) = Vector3d(-std::sin(azimuth), std::cos(azimuth), 0);
  }
  const bool hasCenter = kind == Kind::box || !isUpright(kind);
  solid.center = placeOf(envelope.parameters, hasCenter ? "center" : "base");
  if (!isUpright(kind)) return solid;
  const double height = value("height");
  solid.bottom = solid.center.z() - (kind == Kind::box ? height / 2 : 0);
  solid.top = solid.bottom + height;
  return solid;
}

Envelope envelopeOf(const SimpleSolid& solid) {
  const auto& [first, second, third] = solid.reaches;
  const double height = solid.top - solid.bottom;
  const Vector3d base = middleOf(solid, 0);
  switch (solid.kind) {
  case Kind::ball:
    return ballOf({.center = solid.center, .radius = first});
  case Kind::ellipsoid:
    return ellipsoidOf(solid.center, {first, second, third}, solid.directions);
  case Kind::cylinder:
    return cylinderOf(first, height, base);
  case Kind::cone:
    return coneOf(first, height, base);
  case Kind::frustum:
    return frustumOf(first, second, height, base);
  case Kind::paraboloid:
    return paraboloidOf(first, height, base);
  case Kind::box:
    return boxOf({.along = solid.directions.col(0).head<2>(),
                  .middle = solid.center.head<2>(),
                  .sides = {2 * first, 2 * second}},
                 solid.bottom, solid.top);
  }
  return {};
}

std::vector<EnvelopeHandle> handlesOf(const SimpleSolid& solid) {
  std::vector<EnvelopeHandle> handles;
  const std::vector<Reach> reaches = reachesOf(solid.kind);
  for (std::size_t i = 0; i < reaches.size(); ++i) {
    const Vector3d direction = solid.directions.col(reaches[i].direction);
    handles.push_back({.name = reaches[i].name,
                       .label = reaches[i].label,
                       .place = middleOf(solid, reaches[i].level) + solid.reaches[i] * direction,
                       .up = direction});
  }
  if (isUpright(solid.kind)) {
    handles.push_back({.name = topHandle, .label = Shown::tr("top"), .place = middleOf(solid, 1)});
    handles.push_back(
        {.name = bottomHandle, .label = Shown::tr("bottom"), .place = middleOf(solid, 0)});
  }
  handles.push_back({.name = centerHandle,
                     .label = Shown::tr("center"),
                     .place = middleOf(solid, 0.5),
                     .isFree = true});
  return handles;
}

HandlePlace draggedTo(const SimpleSolid& solid, const std::string& name, const Vector3d& place) {
  const double thin = thinnest(solid);
  if (name == centerHandle) return {.out = place.x(), .level = place.z(), .across = place.y()};
  if (name == topHandle) return {.level = std::max(place.z(), solid.bottom + thin)};
  if (name == bottomHandle) return {.level = std::min(place.z(), solid.top - thin)};
  const std::vector<Reach> reaches = reachesOf(solid.kind);
  const std::optional<std::size_t> reach = reachNamed(reaches, name);
  assert(reach);
  const Vector3d from = place - middleOf(solid, reaches[*reach].level);
  return {.out = std::max(thin, from.dot(solid.directions.col(reaches[*reach].direction)))};
}

SimpleSolid withHandles(SimpleSolid solid, const HandlePlaces& places) {
  const std::vector<Reach> reaches = reachesOf(solid.kind);
  const double thin = thinnest(solid);
  for (const auto& [name, place] : places) {
    if (name == centerHandle) solid.center = {place.out, place.across, place.level};
    if (name == topHandle) solid.top = place.level;
    if (name == bottomHandle) solid.bottom = place.level;
    if (const std::optional<std::size_t> reach = reachNamed(reaches, name))
      solid.reaches[*reach] = std::max(place.out, thin);
  }
  solid.top = std::max(solid.top, solid.bottom + thin); // dragged on another plant
  return solid;
}

} // namespace espalier
