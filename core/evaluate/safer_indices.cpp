#include "core/evaluate/safer_indices.h"

#include <algorithm>

namespace espalier {
namespace {

double totalLength(const std::vector<Segment>& segments) {
  double sum = 0;
  for (const Segment& segment : segments)
    sum += segment.length;
  return sum;
}

} // namespace

double geometricIndexWithin(const AuthorsComparison& comparison, double distance) {
  double near = 0;
  for (const AuthorsComparison::Match& match : comparison.matches)
    if (match.cost <= distance)
      near += comparison.resultSegments[match.result].length +
              comparison.referenceSegments[match.reference].length;
  const double all =
      totalLength(comparison.resultSegments) + totalLength(comparison.referenceSegments);
  return all > 0 ? near / all : 0;
}

double structuralIndexOfAll(const AuthorsComparison& comparison) {
  if (comparison.referenceSegments.empty()) return 0;
  const auto conserved =
      std::ranges::count(comparison.matches, true, &AuthorsComparison::Match::isConserved);
  return static_cast<double>(conserved) / static_cast<double>(comparison.referenceSegments.size());
}

} // namespace espalier
