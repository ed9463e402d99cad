#include "core/graph/likely_up.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

namespace espalier {
namespace {

constexpr double slabShare = 1.0 / 12;  // of the extent
constexpr double footWidth = 0.2;       // of the plant's, at most
constexpr double clearly = 2.5;         // times as wide
constexpr double leastShare = 0.015;    // of all points in a slab
constexpr double leastHeight = 2.0 / 3; // of the extent along z, of a plant along x or y
constexpr std::size_t fewest = 10;      // points of a slab

struct Foot {
  double width = std::numeric_limits<double>::infinity(); // as a share of that of all points
  double share = 0;                                       // of all points in the emptier slab
  double height = 0;                                      // of the plant along the axis [L]
};

double quantileOf(std::vector<double>& values, double share) {
  const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + at, values.end());
  return values[static_cast<std::size_t>(at)];
}

/// How far points lie about their middle across `axis`: the median. Infinite of few points.
double widthOf(const std::vector<const Eigen::Vector3d*>& points, int axis) {
  if (points.size() < fewest) return std::numeric_limits<double>::infinity();
  const std::array<int, 2> across = {(axis + 1) % 3, (axis + 2) % 3};
  Eigen::Vector2d middle;
  std::vector<double> values(points.size());
  for (int side = 0; side < 2; ++side) {
    std::ranges::transform(points, values.begin(),
                           [&](const auto* point) { return (*point)[across[side]]; });
    middle[side] = quantileOf(values, 0.5);
  }
  std::ranges::transform(points, values.begin(), [&](const auto* point) {
    return (Eigen::Vector2d((*point)[across[0]], (*point)[across[1]]) - middle).norm();
  });
  return quantileOf(values, 0.5);
}

/// What might be the foot, at the low end of `axis`.
Foot footAt(const std::vector<Eigen::Vector3d>& points, int axis) {
  std::vector<double> heights(points.size());
  std::ranges::transform(points, heights.begin(), [&](const auto& point) { return point[axis]; });
  const double low = quantileOf(heights, 0.002); // strays lie below
  const double height = quantileOf(heights, 0.998) - low;
  const double slab = slabShare * height;
  std::vector<const Eigen::Vector3d*> all;
  std::array<std::vector<const Eigen::Vector3d*>, 2> slabs;
  for (const Eigen::Vector3d& point : points) {
    all.push_back(&point);
    const double above = point[axis] - low;
    if (above >= 0 && above < 2 * slab) slabs[above < slab ? 0 : 1].push_back(&point);
  }
  const double width = widthOf(all, axis);
  if (!(width > 0)) return {};
  const std::size_t fewer = std::min(slabs[0].size(), slabs[1].size());
  return {std::max(widthOf(slabs[0], axis), widthOf(slabs[1], axis)) / width,
          static_cast<double>(fewer) / static_cast<double>(points.size()), height};
}

} // namespace

std::optional<UpAxis> likelyUp(const std::vector<Eigen::Vector3d>& points) {
  std::vector<Eigen::Vector3d> finite;
  std::ranges::copy_if(points, std::back_inserter(finite),
                       [](const Eigen::Vector3d& point) { return point.allFinite(); });
  if (finite.size() < fewest) return std::nullopt;
  std::array<Foot, 3> feet;
  for (int axis = 0; axis < 3; ++axis)
    feet[static_cast<std::size_t>(axis)] = footAt(finite, axis);
  const auto* best = std::ranges::min_element(feet, {}, &Foot::width);
  const bool isClear = feet[2].width > clearly * best->width;
  if (feet[2].width <= footWidth && !isClear) return UpAxis::z;
  const bool isTall = best->height >= leastHeight * feet[2].height;
  if (best->width <= footWidth && best->share >= leastShare && isClear && isTall)
    return static_cast<UpAxis>(best - feet.begin());
  return std::nullopt;
}

} // namespace espalier
