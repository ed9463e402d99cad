#include "core/graph/densities.h"

#include "core/graph/geodesic_balls.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <iterator>

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

namespace {

/// Between two of them, by steps of which there are `steps` from the first to the last.
float densityAt(const std::vector<float>& sorted, std::size_t step, std::size_t steps) {
  const std::size_t last = sorted.size() - 1;
  const std::size_t place = step * last / steps;
  const auto rest = static_cast<float>(step * last % steps) / static_cast<float>(steps);
  return rest > 0 ? sorted[place] + rest * (sorted[place + 1] - sorted[place]) : sorted[place];
}

/// In [0, 1]; the middle of levels that are the same.
float placeAmong(const std::vector<float>& levels, float density) {
  const auto [from, to] = std::equal_range(levels.begin(), levels.end(), density);
  const auto before = static_cast<float>(from - levels.begin());
  const auto last = static_cast<float>(levels.size() - 1);
  if (from != to) return (before + static_cast<float>(to - from - 1) / 2) / last;
  if (from == levels.begin()) return 0;
  if (from == levels.end()) return 1;
  const float lower = *std::prev(from);
  return (before - 1 + (density - lower) / (*from - lower)) / last;
}

} // namespace

DensityLevels levelsOf(const std::vector<float>& densities, DensityMeasure measure) {
  assert(!densities.empty());
  std::vector<float> sorted = densities;
  std::ranges::sort(sorted);
  if (measure == DensityMeasure::range) {
    const std::size_t rest = (sorted.size() - 1) / 100;
    return {{sorted[rest], sorted[sorted.size() - 1 - rest]}};
  }
  constexpr std::size_t steps = 256;
  DensityLevels result;
  for (std::size_t step = 0; step <= steps; ++step)
    result.levels.push_back(densityAt(sorted, step, steps));
  return result;
}

std::vector<float> normalizedDensities(const std::vector<float>& densities,
                                       const DensityLevels& levels) {
  std::vector<float> result(densities.size(), 0.5F);
  if (!(levels.levels.back() > levels.levels.front())) return result;
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = placeAmong(levels.levels, densities[i]);
  return result;
}

std::vector<float> normalizedDensities(const std::vector<float>& densities,
                                       DensityMeasure measure) {
  if (densities.empty()) return {};
  return normalizedDensities(densities, levelsOf(densities, measure));
}

} // namespace espalier
