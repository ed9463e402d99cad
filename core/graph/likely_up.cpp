#include "core/graph/likely_up.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>

namespace espalier {
namespace {

constexpr double slabShare = 1.0 / 12; // of the extent
constexpr double footWidth = 0.2;      // of the plant's, at most
constexpr double clearly = 2.5;        // times as wide
constexpr std::size_t fewest = 10;     // points of a slab

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

/// How wide the foot at the low end of `axis` is, as a share of the width of all points.
double footAt(const std::vector<Eigen::Vector3d>& points, int axis) {
  std::vector<double> heights(points.size());
  std::ranges::transform(points, heights.begin(), [&](const auto& point) { return point[axis]; });
  const double low = quantileOf(heights, 0.002); // strays lie below
  const double slab = slabShare * (quantileOf(heights, 0.998) - low);
  std::vector<const Eigen::Vector3d*> all;
  std::array<std::vector<const Eigen::Vector3d*>, 2> slabs;
  for (const Eigen::Vector3d& point : points) {
    all.push_back(&point);
    const double above = point[axis] - low;
    if (above >= 0 && above < 2 * slab) slabs[above < slab ? 0 : 1].push_back(&point);
  }
  const double width = widthOf(all, axis);
  if (!(width > 0)) return std::numeric_limits<double>::infinity();
  return std::max(widthOf(slabs[0], axis), widthOf(slabs[1], axis)) / width;
}

} // namespace

std::optional<UpAxis> likelyUp(const std::vector<Eigen::Vector3d>& points) {
  std::vector<Eigen::Vector3d> finite;
  std::ranges::copy_if(points, std::back_inserter(finite),
                       [](const Eigen::Vector3d& point) { return point.allFinite(); });
  if (finite.size() < fewest) return std::nullopt;
  std::array<double, 3> feet{};
  for (int axis = 0; axis < 3; ++axis)
    feet[static_cast<std::size_t>(axis)] = footAt(finite, axis);
  const auto best = static_cast<std::size_t>(std::ranges::min_element(feet) - feet.begin());
  if (feet[2] <= footWidth && feet[2] <= clearly * feet[best]) return UpAxis::z;
  if (feet[best] <= footWidth && feet[2] > clearly * feet[best]) return static_cast<UpAxis>(best);
  return std::nullopt;
}

} // namespace espalier
