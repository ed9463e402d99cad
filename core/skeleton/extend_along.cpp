#include "core/skeleton/extend_along.h"

#include <algorithm>
#include <cassert>
#include <vector>

namespace espalier {
namespace {

using Eigen::Vector3d;

constexpr int stretches = 6;      // that a step is gone in
constexpr std::size_t fewest = 3; // points that are more than dust
constexpr double pull = 0.5;      // share of the distance to the middle of the points, each stretch
constexpr double persistence = 0.5; // share of the old direction in the new one

/// The middle of the points around `center` that lie ahead of `from`; none if they are too few.
std::optional<Vector3d> middleAhead(const SpatialIndex& index, const Eigen::Matrix3Xf& points,
                                    const Vector3d& from, const Vector3d& direction,
                                    const Vector3d& center, double reach) {
  std::vector<Neighbor> near =
      index.within(center.cast<float>(), static_cast<float>(reach)); // in no order that means
  std::ranges::sort(near, {}, &Neighbor::index);                     // anything: sums differ by it
  Vector3d sum = Vector3d::Zero();
  std::size_t count = 0;
  for (const Neighbor& neighbor : near) {
    const Vector3d point = points.col(neighbor.index).cast<double>();
    if ((point - from).dot(direction) <= 0) continue;
    sum += point;
    ++count;
  }
  if (count < fewest) return std::nullopt;
  return sum / static_cast<double>(count);
}

} // namespace

std::optional<Vector3d> extendAlong(const SpatialIndex& index, const Eigen::Matrix3Xf& points,
                                    const Vector3d& from, const Vector3d& direction,
                                    const ExtendOptions& options) {
  assert(options.step > 0 && options.reach > 0 && direction.norm() > 0);
  Vector3d place = from;
  Vector3d ahead = direction.normalized();
  const double stretch = options.step / stretches;
  const double reach = std::max(options.reach, stretch); // else a bend is lost at once
  double gone = 0;
  for (int i = 0; i < stretches; ++i) {
    const Vector3d next = place + stretch * ahead;
    const auto middle = middleAhead(index, points, place, ahead, next, reach);
    if (!middle) break;
    const Vector3d off = *middle - next;
    const Vector3d aside = pull * (off - off.dot(ahead) * ahead);
    const Vector3d onward = (next + aside - place).normalized();
    place += stretch * onward;
    gone += stretch;
    ahead = (persistence * ahead + (1 - persistence) * onward).normalized();
  }
  if (gone < options.step / 4) return std::nullopt;
  return place;
}

} // namespace espalier
