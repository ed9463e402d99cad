#include "core/evaluate/comparison_options.h"

#include <algorithm>

namespace espalier {

double toleranceOr(double tolerance, const Skeleton& reference) {
  return tolerance > 0 ? tolerance : usualTolerance(reference);
}

ComparisonOptions withTolerance(ComparisonOptions options, const Skeleton& reference,
                                double tolerance) {
  std::vector<double>& distances = options.tolerance.distances;
  if (distances.empty()) distances = defaultTolerances(reference);
  const double wanted = toleranceOr(tolerance, reference);
  const auto place = std::ranges::lower_bound(distances, wanted);
  if (place == distances.end() || *place != wanted) distances.insert(place, wanted);
  options.placeDistance = wanted;
  return options;
}

} // namespace espalier
