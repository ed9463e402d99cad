#include "core/evaluate/match/polyline_distance.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace espalier {
namespace {

double squaredDistanceTo(const Polyline& polyline, const Eigen::Vector3d& place) {
  double nearest = std::numeric_limits<double>::infinity();
  if (polyline.size() == 1) nearest = (place - polyline.front()).squaredNorm();
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    const Eigen::Vector3d along = polyline[i] - polyline[i - 1];
    const Eigen::Vector3d arm = place - polyline[i - 1];
    const double squaredLength = along.squaredNorm();
    const double share =
        squaredLength > 0 ? std::clamp(arm.dot(along) / squaredLength, 0.0, 1.0) : 0;
    nearest = std::min(nearest, (arm - share * along).squaredNorm());
  }
  return nearest;
}

} // namespace

Polyline evenPlaces(const Polyline& polyline, double step) {
  assert(!polyline.empty() && step > 0);
  double length = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i)
    length += (polyline[i] - polyline[i - 1]).norm();
  if (length == 0) return {polyline.front()};
  const double parts = std::max(1.0, std::ceil(length / step * (1 - 1e-9))); // rounding adds none
  Polyline places = {polyline.front()};
  double passed = 0;
  for (std::size_t i = 1; i < polyline.size(); ++i) {
    const Eigen::Vector3d along = polyline[i] - polyline[i - 1];
    const double edge = along.norm();
    for (;;) {
      const double at = static_cast<double>(places.size()) * length / parts - passed;
      if (at >= edge || static_cast<double>(places.size()) >= parts) break;
      places.push_back(polyline[i - 1] + at / edge * along);
    }
    passed += edge;
  }
  places.push_back(polyline.back());
  return places;
}

double farthestOf(const Polyline& places, const Polyline& polyline, double limit) {
  assert(!polyline.empty());
  double farthest = 0;
  for (const Eigen::Vector3d& place : places) {
    farthest = std::max(farthest, squaredDistanceTo(polyline, place));
    if (farthest > limit * limit) break;
  }
  return std::sqrt(farthest);
}

} // namespace espalier
