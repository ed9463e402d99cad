#include "core/surface/envelopes/envelope_handles.h"

#include "core/base/shown.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>

namespace espalier {
namespace {

constexpr const char* topName = "top";
constexpr const char* bottomName = "bottom";
constexpr std::array<const char*, 4> sideNames = {Shown::tr("ahead"), Shown::tr("left"),
                                                  Shown::tr("behind"), Shown::tr("right")};

std::optional<std::size_t> sideNamed(const std::string& name) {
  const auto found = std::ranges::find(sideNames, name);
  if (found == sideNames.end()) return std::nullopt;
  return static_cast<std::size_t>(found - sideNames.begin());
}

Eigen::Vector3d outwardOf(const AsymmetricHull& hull, std::size_t side) {
  const double angle = hull.azimuth + std::numbers::pi / 2 * static_cast<double>(side);
  return {std::cos(angle), std::sin(angle), 0};
}

double highestSide(const AsymmetricHull& hull) {
  return *std::ranges::max_element(hull.heights);
}

double lowestSide(const AsymmetricHull& hull) {
  return *std::ranges::min_element(hull.heights);
}

/// Less than this is no radius.
double thinnest(const AsymmetricHull& hull) {
  return 1e-3 * (hull.top.z() - hull.bottom.z());
}

/// How far out a side stands at least, so that an end is within the two quarters beside it.
double leastRadius(const AsymmetricHull& hull, std::size_t side, const Eigen::Vector3d& end) {
  constexpr double within = 1.001;
  const Eigen::Vector2d from = Eigen::Vector2d(end.head<2>()) - hull.center;
  const double along = from.dot(outwardOf(hull, side).head<2>());
  if (along <= 0) return 0;
  const std::size_t next = (side + 1) % 4;
  const double across = from.dot(outwardOf(hull, next).head<2>());
  const double beside = hull.radii[across >= 0 ? next : (side + 3) % 4];
  const double rest = 1 - (across / beside) * (across / beside);
  return rest > 0 ? within * along / std::sqrt(rest) : hull.radii[side];
}

} // namespace

std::vector<EnvelopeHandle> handlesOf(const AsymmetricHull& hull) {
  std::vector<EnvelopeHandle> handles = {
      {.name = topName, .label = Shown::tr("top"), .place = hull.top},
      {.name = bottomName, .label = Shown::tr("bottom"), .place = hull.bottom}};
  for (std::size_t side = 0; side < sideNames.size(); ++side) {
    const Eigen::Vector3d outward = outwardOf(hull, side);
    Eigen::Vector3d place = hull.radii[side] * outward;
    place.head<2>() += hull.center;
    place.z() = hull.heights[side];
    handles.push_back(
        {.name = sideNames[side], .label = sideNames[side], .place = place, .outward = outward});
  }
  return handles;
}

HandlePlace draggedTo(const AsymmetricHull& hull, const std::string& name,
                      const Eigen::Vector3d& place) {
  if (name == topName) return {.level = std::max(place.z(), highestSide(hull))};
  if (name == bottomName) return {.level = std::min(place.z(), lowestSide(hull))};
  const std::optional<std::size_t> side = sideNamed(name);
  assert(side);
  const double out =
      (Eigen::Vector2d(place.head<2>()) - hull.center).dot(outwardOf(hull, *side).head<2>());
  return {.out = std::max({out, thinnest(hull), leastRadius(hull, *side, hull.top),
                           leastRadius(hull, *side, hull.bottom)}),
          .level = std::clamp(place.z(), hull.bottom.z(), hull.top.z())};
}

AsymmetricHull withHandles(AsymmetricHull hull, const HandlePlaces& places) {
  const double thin = thinnest(hull);
  for (const auto& [name, place] : places)
    if (const std::optional<std::size_t> side = sideNamed(name)) {
      hull.radii[*side] = std::max(place.out, thin);
      hull.heights[*side] = place.level;
    }
  if (const auto top = places.find(topName); top != places.end()) hull.top.z() = top->second.level;
  if (const auto bottom = places.find(bottomName); bottom != places.end())
    hull.bottom.z() = bottom->second.level;
  hull.top.z() = std::max(hull.top.z(), highestSide(hull));
  hull.bottom.z() = std::min(hull.bottom.z(), lowestSide(hull));
  for (std::size_t side = 0; side < sideNames.size(); ++side)
    for (const Eigen::Vector3d& end : {hull.top, hull.bottom})
      hull.radii[side] = std::max(hull.radii[side], leastRadius(hull, side, end));
  return hull;
}

AsymmetricHull asymmetricHullOf(const std::vector<EnvelopeParameter>& parameters) {
  AsymmetricHull hull;
  hull.center = placeOf(parameters, "center").head<2>();
  hull.azimuth = valueOf(parameters, "azimuth");
  hull.top = placeOf(parameters, topName);
  hull.bottom = placeOf(parameters, bottomName);
  for (std::size_t side = 0; side < sideNames.size(); ++side) {
    hull.radii[side] = valueOf(parameters, std::string("radius_") + sideNames[side]);
    hull.heights[side] =
        hull.bottom.z() + valueOf(parameters, std::string("height_") + sideNames[side]);
  }
  hull.topShape = valueOf(parameters, "top_shape");
  hull.bottomShape = valueOf(parameters, "bottom_shape");
  return hull;
}

} // namespace espalier
