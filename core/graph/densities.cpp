#include "core/graph/densities.h"

#include "core/graph/geodesic_balls.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace espalier {

std::vector<float> radiusDensities(const NeighborhoodGraph& graph, float radius,
                                   const Progress& progress) {
  assert(radius > 0);
  std::vector<float> densities(static_cast<std::size_t>(graph.size()));
  const auto visit = [&](const GeodesicBalls& balls) {
    std::array<int, GeodesicBalls::most> counts{};
    balls.forEachMember(
        [&](std::size_t center, std::uint32_t /*point*/, float /*distance*/) { ++counts[center]; });
    for (std::size_t i = 0; i < balls.centers().size(); ++i)
      densities[balls.centers()[i]] = static_cast<float>(counts[i]) / (radius * radius);
  };
  forEachGeodesicBalls(
      graph, [&](std::uint32_t /*center*/) { return radius; }, visit, progress);
  return densities;
}

std::vector<float> nearestDensities(const SpatialIndex& points, int count,
                                    const Progress& progress) {
  const auto perPoint = static_cast<float>(std::min<Eigen::Index>(count, points.size() - 1));
  std::vector<float> densities = points.squaredReaches(count, progress);
  float greatest = 0;
  for (float& density : densities) {
    if (density > 0) density = perPoint / density; // was the squared reach
    greatest = std::max(greatest, density);
  }
  for (float& density : densities)
    if (density == 0) density = greatest; // all of its others lie at its place
  return densities;
}

DensityRange rangeOf(const std::vector<float>& densities) {
  assert(!densities.empty());
  std::vector<float> partly = densities; // sorted
  const auto rest = static_cast<std::ptrdiff_t>((densities.size() - 1) / 100);
  const auto most = partly.end() - 1 - rest;
  std::ranges::nth_element(partly, most);
  std::nth_element(partly.begin(), partly.begin() + rest, most);
  return {.least = partly[static_cast<std::size_t>(rest)], .most = *most};
}

std::vector<float> normalizedDensities(const std::vector<float>& densities,
                                       const DensityRange& range) {
  std::vector<float> result(densities.size(), 0.5F);
  if (!(range.most > range.least)) return result;
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = std::clamp((densities[i] - range.least) / (range.most - range.least), 0.0F, 1.0F);
  return result;
}

std::vector<float> normalizedDensities(const std::vector<float>& densities) {
  if (densities.empty()) return {};
  return normalizedDensities(densities, rangeOf(densities));
}

} // namespace espalier
