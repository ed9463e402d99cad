#include "core/pipeline/wood_skin.h"

#include "core/skeleton/frustum.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

double medianOf(std::vector<double>& values) { // pre: not empty. Reorders them
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// @param distances of points near an edge from its axis [L]
double reachOf(std::vector<double>& distances, double radius, double tolerance) {
  constexpr std::size_t fewest = 20;
  const double least = radius + tolerance;
  if (distances.size() < fewest) return least;
  const double middle = medianOf(distances);
  for (double& distance : distances)
    distance = std::abs(distance - middle);
  const double scatter = 3 * 1.4826 * medianOf(distances);
  const double most = 1.25 * std::max(middle, radius) + 2 * tolerance;
  return std::clamp(middle + scatter, least, most);
}

} // namespace

std::vector<double> barkReaches(const Skeleton& skeleton,
                                const std::vector<PointOnSkeleton>& places, double tolerance) {
  std::vector<double> radii(skeleton.idEnd(), 0); // of edges, at the thicker end
  for (const auto& [id, wood] : bodiesOf(skeleton))
    radii[indexOf(id)] = std::max(wood.fromRadius, wood.toRadius);
  std::vector<std::vector<double>> distances(skeleton.idEnd());
  for (const PointOnSkeleton& place : places) {
    const std::size_t edge = indexOf(place.child);
    if (place.distance <= 1.5 * radii[edge] + tolerance) distances[edge].push_back(place.distance);
  }
  std::vector<double> reaches(skeleton.idEnd(), 0);
  for (std::size_t edge = 0; edge < reaches.size(); ++edge)
    reaches[edge] = reachOf(distances[edge], radii[edge], tolerance);
  return reaches;
}

} // namespace espalier
