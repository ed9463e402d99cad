#include "core/reconstruct/leave_wood.h"

#include "core/skeleton/branch_edits.h"
#include "core/skeleton/edits.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace espalier {
namespace {

using Eigen::Vector3d;

/// The wood that a place is deepest in, or whose surface is nearest, and where: a twig that begins
/// in thick wood does not bear what leaves that.
struct Bearer {
  EdgeBody edge;
  double share;
  double toAxis;    // [L]
  double toSurface; // [L], negative inside
};

Bearer bearerAt(const Vector3d& place, const EdgeIndex& wood) {
  const double reach = wood.distanceToSurface(place, [](NodeId) { return true; });
  std::optional<Bearer> best;
  wood.within({place, place}, reach * (1 + 1e-9), [&](const EdgeBody& edge) {
    const double share = edge.body.nearestShare(place);
    const double toAxis = (edge.body.at(share) - place).norm();
    const double toSurface = toAxis - edge.body.radiusAt(share);
    const bool isBetter =
        !best || toSurface < best->toSurface ||
        (toSurface == best->toSurface && edge.node < best->edge.node); // in any order
    if (isBetter) best = {edge, share, toAxis, toSurface};
  });
  assert(best);
  return *best;
}

/// The first place behind the last that is on the wood they begin on.
std::size_t firstOff(const std::vector<Vector3d>& places, const EdgeIndex& wood, double spacing) {
  constexpr double away = 4; // spacings along the places, at least: they do not come back
  std::size_t first = 0;
  double off = 0;
  double most = away * spacing;
  for (std::size_t i = 0; i < places.size() && off < most; ++i) {
    const Bearer bearer = bearerAt(places[i], wood);
    if (bearer.toSurface <= spacing) {
      first = i + 1;
      off = 0;
      most = std::max(away * spacing, 1.5 * (bearer.toAxis - bearer.toSurface));
    } else if (i > 0)
      off += (places[i] - places[i - 1]).norm();
  }
  return first;
}

/// The line along which some places lie, from one of them on.
struct Course {
  Vector3d middle;    // of these places
  Vector3d direction; // of length 1, or 0
};

Course courseFrom(const std::vector<Vector3d>& places, std::size_t first, double length) {
  std::size_t end = first + 2;
  while (end < places.size() && (places[end] - places[first]).norm() <= length)
    ++end;
  const auto meanOf = [&](std::size_t from, std::size_t to) {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = from; i < to; ++i)
      sum += places[i];
    return Vector3d(sum / static_cast<double>(to - from));
  };
  const std::size_t part = std::max<std::size_t>(1, (end - first) / 3);
  return {meanOf(first, end), (meanOf(end - part, end) - meanOf(first, first + part)).normalized()};
}

/// By how much what leads from a place of the wood to another turns off from it: its cosine.
double cosineAt(const Bearer& bearer, const Vector3d& to) {
  const Vector3d along = bearer.edge.body.to - bearer.edge.body.from;
  const Vector3d off = to - bearer.edge.body.at(bearer.share);
  const double lengths = along.norm() * off.norm();
  return lengths > 0 ? along.dot(off) / lengths : 1;
}

/// Branches do not fold back: if this one did, it begins farther down, where it does so no more.
Bearer withoutFold(const Bearer& begin, const Vector3d& next, const EdgeIndex& wood,
                   double spacing) {
  constexpr double least = -0.17; // cosine of 100 degrees
  if (cosineAt(begin, next) >= least) return begin;
  Bearer best = begin;
  double nearest = begin.toAxis + 6 * spacing;
  wood.within({next, next}, 2 * begin.toAxis + 6 * spacing, [&](const EdgeBody& edge) {
    constexpr int parts = 8;
    for (int i = 0; i <= parts; ++i) {
      Bearer other = begin;
      other.edge = edge;
      other.share = static_cast<double>(i) / parts;
      const double distance = (edge.body.at(other.share) - begin.edge.body.at(begin.share)).norm();
      const bool isThis =
          edge.body.radiusAt(other.share) >= begin.edge.body.radiusAt(begin.share) / 2;
      if (distance >= nearest || !isThis || cosineAt(other, next) < least) continue;
      nearest = distance;
      best = other;
    }
  });
  return best;
}

} // namespace

std::optional<Leaving> leavingWood(const std::vector<Vector3d>& places, const EdgeIndex& wood,
                                   double spacing) {
  assert(spacing > 0);
  const std::size_t first = firstOff(places, wood, spacing);
  if (first == 0 || first + 1 >= places.size()) return std::nullopt;
  constexpr double widest = 6; // spacings: across more, a course leads nowhere
  Bearer begin = bearerAt(places[first], wood);
  if (begin.toSurface > widest * spacing) begin = bearerAt(places[first - 1], wood);
  const double reach = begin.toAxis;
  const double thick = begin.toAxis - begin.toSurface;
  const Course course = courseFrom(places, first, std::max(2 * reach, 8 * spacing));
  const double before = (course.middle - places[first]).norm();
  for (double back = before; back <= before + 2 * reach; back += spacing / 2) {
    const Bearer bearer = bearerAt(course.middle - back * course.direction, wood);
    const bool isThis = bearer.toAxis - bearer.toSurface >= thick / 2;
    if (isThis && bearer.toAxis < begin.toAxis) begin = bearer;
  }
  begin = withoutFold(begin, places[first], wood, spacing);
  const double length = begin.edge.body.length();
  constexpr double nearNode = 2; // spacings
  double share = begin.share;
  if ((1 - share) * length <= nearNode * spacing)
    share = 1;
  else if (share * length <= nearNode * spacing)
    share = 0;
  return Leaving{first, {begin.edge.node, share}, begin.edge.body.at(share)};
}

NodeId addTrace(SkeletonEditor& editor, const Trace& trace) {
  assert(trace.begin && !trace.places.empty());
  const auto [on, fraction] = *trace.begin;
  const std::optional<NodeId> below = editor.skeleton()[on].parent;
  NodeId parent = on;
  if (fraction < 1 && below) parent = fraction > 0 ? splitEdge(editor, on, fraction) : *below;
  if (trace.places.size() == 1) return parent;
  return addBranch(editor, parent, {trace.places.begin() + 1, trace.places.end()},
                   {trace.radii.begin() + 1, trace.radii.end()});
}

} // namespace espalier
