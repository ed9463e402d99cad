#include "core/cloud/spacing_of_places.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace espalier {
namespace {

/// From a point to the nearest one at another place [L]; 0 if there is none.
double distanceToOthers(const Eigen::Matrix3Xf& points, const SpatialIndex& index,
                        Eigen::Index point) {
  constexpr int nearest = 8; // one alone is at the place of the point
  const Eigen::Vector3f place = points.col(point);
  for (const Neighbor& neighbor : index.nearest(place, nearest))
    if (neighbor.squaredDistance > 0)
      return std::sqrt(static_cast<double>(neighbor.squaredDistance));
  const auto isApart = [&](Eigen::Index other) {
    return (points.col(other) - place).squaredNorm() > 0;
  };
  const auto other = index.nearestIf(place, std::numeric_limits<float>::infinity(), isApart);
  return other ? std::sqrt(static_cast<double>(other->squaredDistance)) : 0;
}

constexpr double mostMedians = 16;

/// Mean of those that are not many times the median: these are from strays.
double meanOfNear(const std::vector<double>& distances) {
  std::vector<double> sorted = distances;
  const auto middle = sorted.begin() + std::ssize(sorted) / 2;
  std::nth_element(sorted.begin(), middle, sorted.end());
  double sum = 0;
  Eigen::Index near = 0;
  for (const double distance : distances) {
    if (distance > mostMedians * *middle) continue;
    sum += distance;
    ++near;
  }
  return sum / static_cast<double>(near);
}

} // namespace

double spacingOfPlaces(const Eigen::Matrix3Xf& points, const SpatialIndex& index,
                       const std::vector<Eigen::Index>& places) {
  constexpr Eigen::Index samples = 20000;
  const Eigen::Index count = std::min(std::ssize(places), samples);
  std::vector<double> distances(static_cast<std::size_t>(count));
  parallelFor(count, [&](Eigen::Index i) {
    const auto place = static_cast<std::size_t>(i * std::ssize(places) / count);
    distances[static_cast<std::size_t>(i)] = distanceToOthers(points, index, places[place]);
  });
  std::erase(distances, 0);
  return distances.empty() ? 0 : meanOfNear(distances);
}

} // namespace espalier
