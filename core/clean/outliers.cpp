#include "core/clean/outliers.h"

#include <algorithm>
#include <cmath>

namespace espalier {

std::vector<bool> statisticalOutliers(const SpatialIndex& points, const OutlierOptions& options,
                                      const Progress& progress) {
  const auto count = static_cast<std::size_t>(points.size());
  std::vector<bool> isOutlier(count, false);
  if (points.size() <= options.neighbors) return isOutlier;
  const NearestOthers others = points.nearestOthers(options.neighbors, progress.part(0, 0.9));
  const auto perPoint = static_cast<std::size_t>(others.perPoint);
  std::vector<double> means(count);
  double sum = 0;
  double squares = 0;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i * perPoint; j < (i + 1) * perPoint; ++j)
      means[i] += std::sqrt(static_cast<double>(others.squaredDistances[j]));
    means[i] /= static_cast<double>(perPoint);
    sum += means[i];
  }
  const double mean = sum / static_cast<double>(count);
  for (const double each : means)
    squares += (each - mean) * (each - mean);
  const double limit = mean + options.deviations * std::sqrt(squares / static_cast<double>(count));
  for (std::size_t i = 0; i < count; ++i)
    isOutlier[i] = means[i] > limit;
  progress.update(1);
  return isOutlier;
}

std::vector<bool> sparsestPoints(const SpatialIndex& points, const SparsePointOptions& options,
                                 const Progress& progress) {
  const auto count = static_cast<std::size_t>(points.size());
  std::vector<bool> isSparse(count, false);
  if (points.size() <= options.neighbors) return isSparse;
  const std::vector<float> reaches =
      points.squaredReaches(options.neighbors, progress.part(0, 0.9));
  const auto leftOut = static_cast<std::ptrdiff_t>(options.share * static_cast<double>(count));
  std::vector<float> sorted = reaches;
  const auto last = sorted.end() - leftOut - 1; // the thinnest that stays
  std::ranges::nth_element(sorted, last);
  for (std::size_t i = 0; i < count; ++i)
    isSparse[i] = reaches[i] > *last;
  progress.update(1);
  return isSparse;
}

} // namespace espalier
