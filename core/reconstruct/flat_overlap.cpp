#include "core/reconstruct/flat_overlap.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <vector>

namespace espalier {
namespace {

using Polygon = std::vector<Eigen::Vector2d>; // convex, counterclockwise

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double area(const Polygon& polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    twice += cross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return twice / 2;
}

Polygon outline(const Frustum& wood, const Eigen::Vector3d& x, const Eigen::Vector3d& y) {
  const Eigen::Vector2d from(x.dot(wood.from), y.dot(wood.from));
  const Eigen::Vector2d to(x.dot(wood.to), y.dot(wood.to));
  const Eigen::Vector2d along = (to - from).normalized();
  const Eigen::Vector2d right(along.y(), -along.x());
  return {from + wood.fromRadius * right, to + wood.toRadius * right, to - wood.toRadius * right,
          from - wood.fromRadius * right};
}

/// What of `polygon` lies to the left of the line through two places (I. Sutherland, G. Hodgman,
/// "Reentrant polygon clipping", 1974).
Polygon clipped(const Polygon& polygon, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  Polygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    const double atA = cross(to - from, a - from);
    const double atB = cross(to - from, b - from);
    if (atA >= 0) result.push_back(a);
    if ((atA > 0 && atB < 0) || (atA < 0 && atB > 0))
      result.emplace_back(a + atA / (atA - atB) * (b - a));
  }
  return result;
}

} // namespace

double flatOverlap(const Frustum& a, const Frustum& b) {
  const Frustum here = {a.from - b.from, a.to - b.from, a.fromRadius, a.toRadius}; // small numbers
  const Frustum there = {Eigen::Vector3d::Zero(), b.to - b.from, b.fromRadius, b.toRadius};
  const Eigen::Vector3d along = here.to - here.from;
  if (along.norm() == 0 || there.to.norm() == 0) return 0;
  const Eigen::Vector3d x = along.normalized();
  const Eigen::Vector3d across = there.to - there.to.dot(x) * x;
  const Eigen::Vector3d y = across.norm() > 1e-9 * there.to.norm()
                                ? Eigen::Vector3d(across.normalized())
                                : Eigen::Vector3d(x.unitOrthogonal());
  const Polygon first = outline(here, x, y);
  const Polygon second = outline(there, x, y);
  const double smaller = std::min(area(first), area(second));
  if (!(smaller > 0)) return 0;
  Polygon common = first;
  for (std::size_t i = 0; i < second.size() && !common.empty(); ++i) {
    const Eigen::Vector2d& next = second[(i + 1) % second.size()];
    if (next != second[i]) common = clipped(common, second[i], next); // tips have no width
  }
  return std::clamp(area(common) / smaller, 0.0, 1.0);
}

} // namespace espalier
