#include "core/surface/envelopes/skinned_handles.h"

#include "core/base/shown_message.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>

namespace espalier {
namespace {

constexpr const char* topOfSkinned = "top";
constexpr const char* bottomOfSkinned = "bottom";
constexpr std::size_t mostSides = 8;

/// A place of each profile that has handles, halfway down, straight out or halfway up.
struct SkinLevel {
  const char* name;
  const char* label;
  std::size_t place; // of the profile
};
constexpr std::array<SkinLevel, 3> skinLevels = {
    SkinLevel{"low", Shown::tr("side %1, low"), skinnedLevels / 4},
    SkinLevel{"middle", Shown::tr("side %1, middle"), skinnedLevels / 2},
    SkinLevel{"high", Shown::tr("side %1, high"), skinnedLevels * 3 / 4}};
using Shifts = std::array<double, skinLevels.size()>; // [L], at each level

std::string handleName(std::size_t side, const SkinLevel& level) {
  return "side_" + std::to_string(side + 1) + "_" + level.name;
}

std::size_t sidesOf(const SkinnedHull& hull) {
  return std::min(mostSides, hull.profiles.size());
}

/// That a side with handles is.
std::size_t profileOf(const SkinnedHull& hull, std::size_t side) {
  return side * hull.profiles.size() / sidesOf(hull);
}

double thinnest(const SkinnedHull& hull) {
  return 1e-3 * (hull.axis.second - hull.axis.first);
}

/// From the axis to a place of a profile [L].
double outOf(const SkinnedHull& hull, std::size_t profile, const SkinLevel& level) {
  return hull.profiles[profile][level.place].x() * reachTo(hull, profile);
}

/// How far out the places of a side were dragged.
Shifts shiftsOf(const SkinnedHull& hull, std::size_t side, const HandlePlaces& places) {
  Shifts shifts{};
  for (std::size_t i = 0; i < skinLevels.size(); ++i)
    if (const auto place = places.find(handleName(side, skinLevels[i])); place != places.end())
      shifts[i] = std::max(place->second.out, thinnest(hull)) -
                  outOf(hull, profileOf(hull, side), skinLevels[i]);
  return shifts;
}

/// Of a profile between two sides, by how near it is to each.
Shifts shiftsBetween(const SkinnedHull& hull, const std::vector<Shifts>& sides,
                     std::size_t profile) {
  std::size_t before = 0;
  while (before + 1 < sides.size() && profileOf(hull, before + 1) <= profile)
    ++before;
  const std::size_t next = before + 1;
  const std::size_t begin = profileOf(hull, before);
  const std::size_t end = next < sides.size() ? profileOf(hull, next) : hull.profiles.size();
  const double share = static_cast<double>(profile - begin) / static_cast<double>(end - begin);
  Shifts shifts{};
  for (std::size_t i = 0; i < shifts.size(); ++i)
    shifts[i] = std::lerp(sides[before][i], sides[next % sides.size()][i], share);
  return shifts;
}

/// Places at the height of a handle go out with it, those farther up and down less and less.
void widen(SkinnedHull& hull, std::size_t profile, const Shifts& shifts) {
  SkinnedHull::Profile& places = hull.profiles[profile];
  const double thin = thinnest(hull);
  struct Knot {
    double z, times;
  };
  const auto z = [](const Eigen::Vector2d& place) { return place.y(); };
  std::vector<Knot> knots = {{std::min(hull.axis.first, std::ranges::min(places, {}, z).y()), 1}};
  for (std::size_t i = 0; i < skinLevels.size(); ++i) {
    const double out = std::max(outOf(hull, profile, skinLevels[i]), thin);
    knots.push_back({places[skinLevels[i].place].y(), std::max(out + shifts[i], thin) / out});
  }
  knots.push_back({std::max(hull.axis.second, std::ranges::max(places, {}, z).y()), 1});
  for (Eigen::Vector2d& place : places) {
    const auto above = std::ranges::find_if(knots.begin() + 1, knots.end() - 1,
                                            [&](const Knot& knot) { return knot.z >= place.y(); });
    const Knot& below = above[-1];
    const double share = above->z > below.z ? (place.y() - below.z) / (above->z - below.z) : 0;
    place.x() *= std::lerp(below.times, above->times, share);
  }
}

/// Higher or lower as a whole.
void stretch(SkinnedHull& hull, const HandlePlaces& places) {
  const auto [bottom, top] = hull.axis;
  const auto high = places.find(topOfSkinned);
  const auto low = places.find(bottomOfSkinned);
  const double to = high != places.end() ? high->second.level : top;
  const double from =
      std::min(low != places.end() ? low->second.level : bottom, to - thinnest(hull));
  hull.axis = {from, to};
  for (SkinnedHull::Profile& profile : hull.profiles)
    for (Eigen::Vector2d& place : profile)
      place.y() = from + (place.y() - bottom) / (top - bottom) * (to - from);
}

struct SkinHandle {
  std::size_t side = 0;
  const SkinLevel* level = nullptr;
};

std::optional<SkinHandle> skinHandleNamed(const std::string& name) {
  for (std::size_t side = 0; side < mostSides; ++side)
    for (const SkinLevel& level : skinLevels)
      if (handleName(side, level) == name) return SkinHandle{side, &level};
  return std::nullopt;
}

} // namespace

std::vector<std::string> skinnedHandleNames() {
  std::vector<std::string> names = {topOfSkinned, bottomOfSkinned};
  for (std::size_t side = 0; side < mostSides; ++side)
    for (const SkinLevel& level : skinLevels)
      names.push_back(handleName(side, level));
  return names;
}

std::vector<EnvelopeHandle> handlesOf(const SkinnedHull& hull) {
  const Eigen::Vector3d middle(hull.middle.x(), hull.middle.y(), 0);
  std::vector<EnvelopeHandle> handles = {
      {.name = topOfSkinned,
       .label = Shown::tr("top"),
       .place = middle + hull.axis.second * Eigen::Vector3d::UnitZ()},
      {.name = bottomOfSkinned,
       .label = Shown::tr("bottom"),
       .place = middle + hull.axis.first * Eigen::Vector3d::UnitZ()}};
  for (std::size_t side = 0; side < sidesOf(hull); ++side) {
    const std::size_t profile = profileOf(hull, side);
    const double azimuth = azimuthOf(hull, profile);
    const Eigen::Vector3d outward(std::cos(azimuth), std::sin(azimuth), 0);
    for (const SkinLevel& level : skinLevels)
      handles.push_back(
          {.name = handleName(side, level),
           .label = inEnglish({level.label, {std::to_string(side + 1)}}),
           .place = middle + outOf(hull, profile, level) * outward +
                    hull.profiles[profile][level.place].y() * Eigen::Vector3d::UnitZ(),
           .up = outward});
  }
  return handles;
}

HandlePlace draggedTo(const SkinnedHull& hull, const std::string& name,
                      const Eigen::Vector3d& place) {
  const double thin = thinnest(hull);
  if (name == topOfSkinned) return {.level = std::max(place.z(), hull.axis.first + thin)};
  if (name == bottomOfSkinned) return {.level = std::min(place.z(), hull.axis.second - thin)};
  const std::optional<SkinHandle> handle = skinHandleNamed(name);
  assert(handle && handle->side < sidesOf(hull));
  const double azimuth = azimuthOf(hull, profileOf(hull, handle->side));
  const Eigen::Vector2d outward(std::cos(azimuth), std::sin(azimuth));
  return {.out = std::max(outward.dot(place.head<2>() - hull.middle), thin)};
}

SkinnedHull withHandles(SkinnedHull hull, const HandlePlaces& places) {
  std::vector<Shifts> sides;
  for (std::size_t side = 0; side < sidesOf(hull); ++side)
    sides.push_back(shiftsOf(hull, side, places));
  for (std::size_t profile = 0; profile < hull.profiles.size(); ++profile)
    widen(hull, profile, shiftsBetween(hull, sides, profile));
  stretch(hull, places);
  return hull;
}

} // namespace espalier
