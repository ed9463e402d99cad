#include "core/cloud/isolated_points.h"

#include <cmath>

namespace espalier {

std::vector<bool> isolatedPoints(const SpatialIndex& points, const IsolatedPointOptions& options,
                                 const Progress& progress) {
  std::vector<bool> result(static_cast<std::size_t>(points.size()), false);
  if (points.size() <= options.neighbors) return result;
  const NearestOthers others = points.nearestOthers(options.neighbors, progress.part(0, 0.9));
  const auto perPoint = static_cast<std::size_t>(others.perPoint);
  for (std::size_t i = 0; i < result.size(); ++i) {
    double sum = 0;
    for (std::size_t j = i * perPoint; j < (i + 1) * perPoint; ++j)
      sum += std::sqrt(static_cast<double>(others.squaredDistances[j]));
    result[i] = sum / static_cast<double>(perPoint) > options.distance;
  }
  progress.update(1);
  return result;
}

bool isIsolated(const SpatialIndex& points, const Eigen::Vector3f& place,
                const IsolatedPointOptions& options) {
  const std::vector<Neighbor> found = points.nearest(place, options.neighbors + 1); // and itself
  if (std::ssize(found) <= options.neighbors) return false;
  double sum = 0;
  for (const Neighbor& neighbor : found)
    sum += std::sqrt(static_cast<double>(neighbor.squaredDistance));
  return sum / options.neighbors > options.distance;
}

} // namespace espalier
