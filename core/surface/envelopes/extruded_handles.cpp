#include "core/surface/envelopes/extruded_handles.h"

#include "core/base/shown.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>
#include <optional>

namespace espalier {
namespace {

constexpr const char* topOfExtruded = "top";
constexpr const char* bottomOfExtruded = "bottom";

/// A place of the side profile.
struct SideHandle {
  const char* name;
  const char* label;
  bool isAhead;
  double level; // from the lowest (0) to the highest section (1)
};
constexpr std::array<SideHandle, 6> sideHandles = {
    SideHandle{"ahead_low", Shown::tr("ahead, low"), true, 0.25},
    SideHandle{"ahead_middle", Shown::tr("ahead, in the middle"), true, 0.5},
    SideHandle{"ahead_high", Shown::tr("ahead, high"), true, 0.75},
    SideHandle{"behind_low", Shown::tr("behind, low"), false, 0.25},
    SideHandle{"behind_middle", Shown::tr("behind, in the middle"), false, 0.5},
    SideHandle{"behind_high", Shown::tr("behind, high"), false, 0.75}};

/// A place of the outline.
struct OutlineHandle {
  const char* name;
  const char* label;
  int eighths; // of a turn, from where the side profile goes ahead to the left
};
constexpr std::array<OutlineHandle, 6> outlineHandles = {
    OutlineHandle{"outline_ahead_left", Shown::tr("outline, ahead to the left"), 1},
    OutlineHandle{"outline_left", Shown::tr("outline, left"), 2},
    OutlineHandle{"outline_behind_left", Shown::tr("outline, behind to the left"), 3},
    OutlineHandle{"outline_behind_right", Shown::tr("outline, behind to the right"), 5},
    OutlineHandle{"outline_right", Shown::tr("outline, right"), 6},
    OutlineHandle{"outline_ahead_right", Shown::tr("outline, ahead to the right"), 7}};
constexpr double eighth = std::numbers::pi / 4;

template <class Handles> auto handleIn(const Handles& handles, const std::string& name) {
  const auto found = std::ranges::find(handles, name, [](const auto& each) { return each.name; });
  return found == handles.end() ? nullptr : &*found;
}

double heightOf(const ExtrudedHull& hull) {
  return hull.side.back().z - hull.side.front().z;
}

double levelOf(const ExtrudedHull& hull, double share) {
  return std::lerp(hull.side.front().z, hull.side.back().z, share);
}

/// Less than this is no width.
double thinnest(const ExtrudedHull& hull) {
  return 1e-3 * (hull.ahead + hull.behind);
}

/// pre: z is between the lowest and the highest section
ProfileSection sectionAt(const ExtrudedHull& hull, double z) {
  const auto above = std::ranges::lower_bound(hull.side, z, {}, &ProfileSection::z);
  if (above == hull.side.begin()) return hull.side.front();
  if (above == hull.side.end()) return hull.side.back();
  const ProfileSection& below = above[-1];
  const double share = (z - below.z) / (above->z - below.z);
  return {.z = z,
          .from = std::lerp(below.from, above->from, share),
          .to = std::lerp(below.to, above->to, share)};
}

double alongOfMiddle(const ExtrudedHull& hull) {
  return hull.along.dot(hull.middle);
}

/// How far out a side is at a section, from the middle of the outline; less than 0 where it is
/// beyond.
double outOf(const ExtrudedHull& hull, const ProfileSection& section, bool isAhead) {
  return isAhead ? section.to - alongOfMiddle(hull) : alongOfMiddle(hull) - section.from;
}

Eigen::Vector2d directionAt(const ExtrudedHull& hull, double turn) {
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  return {c * hull.along.x() - s * hull.along.y(), s * hull.along.x() + c * hull.along.y()};
}

/// How far the outline reaches from its middle.
double reachOf(const ExtrudedHull& hull, const Eigen::Vector2d& direction) {
  double reach = 0;
  for (std::size_t i = 0; i < hull.outline.size(); ++i) {
    const Eigen::Vector2d a = hull.outline[i] - hull.middle;
    const Eigen::Vector2d step = hull.outline[(i + 1) % hull.outline.size()] - hull.middle - a;
    const double across = direction.x() * step.y() - direction.y() * step.x();
    if (across == 0) continue;
    const double at = (a.y() * direction.x() - a.x() * direction.y()) / -across; // of the side
    const double out = (a.x() * step.y() - a.y() * step.x()) / across;
    if (at >= -1e-12 && at <= 1 + 1e-12) reach = std::max(reach, out);
  }
  return reach;
}

std::optional<HandlePlace> placeIn(const HandlePlaces& places, const std::string& name) {
  const auto found = places.find(name);
  return found == places.end() ? std::nullopt : std::optional(found->second);
}

/// Higher or lower as a whole.
void stretch(ExtrudedHull& hull, const HandlePlaces& places) {
  const double bottom = hull.side.front().z;
  const double height = heightOf(hull);
  const auto top = placeIn(places, topOfExtruded);
  const auto low = placeIn(places, bottomOfExtruded);
  const double to = top ? top->level : bottom + height;
  const double from = std::min(low ? low->level : bottom, to - 1e-3 * height);
  for (ProfileSection& section : hull.side)
    section.z = from + (section.z - bottom) / height * (to - from);
}

/// With a section at each level that has handles.
void bendAtHandles(ExtrudedHull& hull) {
  for (const SideHandle& handle : sideHandles) {
    const ProfileSection section = sectionAt(hull, levelOf(hull, handle.level));
    const auto above = std::ranges::lower_bound(hull.side, section.z, {}, &ProfileSection::z);
    if (above->z != section.z) hull.side.insert(above, section);
  }
}

/// How much farther out a side is than it was at the bottom, at its three handles and at the top.
std::array<double, 5> sideShifts(const ExtrudedHull& hull, const HandlePlaces& places,
                                 bool isAhead) {
  std::array<double, 5> shifts{}; // the ends stay
  for (const SideHandle& handle : sideHandles)
    if (const auto place = placeIn(places, handle.name); place && handle.isAhead == isAhead)
      shifts[static_cast<std::size_t>(4 * handle.level)] =
          place->out - outOf(hull, sectionAt(hull, levelOf(hull, handle.level)), isAhead);
  return shifts;
}

/// Between numbers in a row. pre: at is in [0, their count - 1]
template <class Numbers> double between(const Numbers& numbers, double at) {
  const auto before = std::min(static_cast<std::size_t>(at), numbers.size() - 2);
  return std::lerp(numbers[before], numbers[before + 1], at - static_cast<double>(before));
}

/// Each side out or in as its handles are, and less and less to the next handle or the end.
void shiftSides(ExtrudedHull& hull, const HandlePlaces& places) {
  bendAtHandles(hull);
  const auto ahead = sideShifts(hull, places, true);
  const auto behind = sideShifts(hull, places, false);
  const double bottom = hull.side.front().z;
  const double height = heightOf(hull);
  for (ProfileSection& section : hull.side) {
    const double at = 4 * (section.z - bottom) / height;
    const double least = std::min(thinnest(hull), section.to - section.from); // of a tip: none
    section.to += between(ahead, at);
    section.from -= between(behind, at);
    if (section.to - section.from >= least) continue;
    const double middle = (section.from + section.to) / 2;
    section.from = middle - least / 2;
    section.to = middle + least / 2;
  }
}

/// A corner of the outline, about its middle.
struct TurnAndReach {
  double turn; // from `along` to the left, in [0, 2 pi)
  double out;
};

/// The corners of the outline, and a place at each eighth of a turn.
std::vector<TurnAndReach> cornersAround(const ExtrudedHull& hull) {
  std::vector<TurnAndReach> corners;
  corners.reserve(8 + hull.outline.size());
  for (int i = 0; i < 8; ++i)
    corners.push_back({eighth * i, reachOf(hull, directionAt(hull, eighth * i))});
  const Eigen::Vector2d left(-hull.along.y(), hull.along.x());
  for (const Eigen::Vector2d& corner : hull.outline) {
    const Eigen::Vector2d from = corner - hull.middle;
    const double turn = std::atan2(left.dot(from), hull.along.dot(from));
    corners.push_back({turn < 0 ? turn + 8 * eighth : turn, from.norm()});
  }
  std::ranges::sort(corners, {}, &TurnAndReach::turn);
  return corners;
}

/// The outline likewise, by eighths of a turn; it stays between its ends ahead and behind.
void shiftOutline(ExtrudedHull& hull, const HandlePlaces& places) {
  std::array<double, 9> shifts{}; // the last is the first
  for (const OutlineHandle& handle : outlineHandles)
    if (const auto place = placeIn(places, handle.name))
      shifts[static_cast<std::size_t>(handle.eighths)] =
          place->out - reachOf(hull, directionAt(hull, eighth * handle.eighths));
  const std::vector<TurnAndReach> corners = cornersAround(hull);
  hull.outline.clear();
  for (const TurnAndReach& corner : corners) {
    const double out = std::max(corner.out + between(shifts, corner.turn / eighth), thinnest(hull));
    const Eigen::Vector2d place = out * directionAt(hull, corner.turn);
    const double ahead = hull.along.dot(place);
    hull.outline.emplace_back(hull.middle + place +
                              (std::clamp(ahead, -hull.behind, hull.ahead) - ahead) * hull.along);
  }
}

} // namespace

std::vector<std::string> extrudedHandleNames() {
  std::vector<std::string> names = {topOfExtruded, bottomOfExtruded};
  for (const SideHandle& handle : sideHandles)
    names.emplace_back(handle.name);
  for (const OutlineHandle& handle : outlineHandles)
    names.emplace_back(handle.name);
  return names;
}

std::vector<EnvelopeHandle> handlesOf(const ExtrudedHull& hull) {
  std::vector<EnvelopeHandle> handles = {{.name = topOfExtruded,
                                          .label = Shown::tr("top"),
                                          .place = placedIn(hull, hull.side.back(), hull.middle)},
                                         {.name = bottomOfExtruded,
                                          .label = Shown::tr("bottom"),
                                          .place = placedIn(hull, hull.side.front(), hull.middle)}};
  const Eigen::Vector3d along(hull.along.x(), hull.along.y(), 0);
  for (const SideHandle& handle : sideHandles) {
    const ProfileSection section = sectionAt(hull, levelOf(hull, handle.level));
    const double sign = handle.isAhead ? 1 : -1;
    const Eigen::Vector3d middle(hull.middle.x(), hull.middle.y(), section.z);
    handles.push_back({.name = handle.name,
                       .label = handle.label,
                       .place = middle + sign * outOf(hull, section, handle.isAhead) * along,
                       .up = sign * along});
  }
  for (const OutlineHandle& handle : outlineHandles) {
    const Eigen::Vector2d direction = directionAt(hull, eighth * handle.eighths);
    handles.push_back({.name = handle.name,
                       .label = handle.label,
                       .place = placedIn(hull, widestSection(hull),
                                         hull.middle + reachOf(hull, direction) * direction),
                       .up = {direction.x(), direction.y(), 0}});
  }
  return handles;
}

HandlePlace draggedTo(const ExtrudedHull& hull, const std::string& name,
                      const Eigen::Vector3d& place) {
  const double thin = 1e-3 * heightOf(hull);
  if (name == topOfExtruded) return {.level = std::max(place.z(), hull.side.front().z + thin)};
  if (name == bottomOfExtruded) return {.level = std::min(place.z(), hull.side.back().z - thin)};
  if (const SideHandle* side = handleIn(sideHandles, name)) {
    const ProfileSection section = sectionAt(hull, levelOf(hull, side->level));
    const double x = hull.along.dot(place.head<2>()) - alongOfMiddle(hull);
    return {.out = std::max(side->isAhead ? x : -x,
                            thinnest(hull) - outOf(hull, section, !side->isAhead))};
  }
  const OutlineHandle* outline = handleIn(outlineHandles, name);
  assert(outline != nullptr);
  const ProfileSection& widest = widestSection(hull);
  const Eigen::Vector2d direction = directionAt(hull, eighth * outline->eighths);
  const Eigen::Vector3d middle = placedIn(hull, widest, hull.middle);
  const double scale = (widest.to - widest.from) / (hull.ahead + hull.behind);
  const double out = direction.dot((place - middle).head<2>()) / scale;
  const double ahead = direction.dot(hull.along); // it stays within the ends of the outline
  const double most =
      std::abs(ahead) < 1e-9 ? out : (ahead > 0 ? hull.ahead : hull.behind) / std::abs(ahead);
  return {.out = std::max(std::min(out, most), thinnest(hull))};
}

ExtrudedHull withHandles(ExtrudedHull hull, const HandlePlaces& places) {
  stretch(hull, places);
  shiftSides(hull, places);
  shiftOutline(hull, places);
  return hull;
}

} // namespace espalier
