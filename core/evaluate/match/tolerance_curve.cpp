#include "core/evaluate/match/tolerance_curve.h"

#include "core/base/parallel.h"
#include "core/base/shown_message.h"
#include "core/evaluate/match/comparable.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace espalier {
namespace {

/// Rounded to one decimal digit. pre: value > 0
double rounded(double value) {
  const double power = std::floor(std::log10(value));
  // Powers of ten under one have no exact double: dividing by their inverse rounds only once.
  if (power < 0) {
    const double inverse = std::pow(10.0, -power);
    return std::round(value * inverse) / inverse;
  }
  const double unit = std::pow(10.0, power);
  return std::round(value / unit) * unit;
}

/// pre: sorted
double shareWithin(const std::vector<double>& distances, double tolerance) {
  const auto end = std::upper_bound(distances.begin(), distances.end(), tolerance);
  return static_cast<double>(end - distances.begin()) / static_cast<double>(distances.size());
}

/// @param near that far off is as good as there. pre: sorted, not empty
DistanceSummary summary(const std::vector<double>& distances, double near) {
  const auto count = static_cast<double>(distances.size());
  const auto rank = static_cast<std::size_t>(std::ceil(0.95 * count)) - 1;
  const auto far = std::upper_bound(distances.begin(), distances.end(), near);
  const auto farCount = static_cast<double>(distances.end() - far);
  return {.mean = std::accumulate(distances.begin(), distances.end(), 0.0) / count,
          .percentile95 = distances[rank],
          .farShare = farCount / count,
          .farMean = farCount > 0 ? std::accumulate(far, distances.end(), 0.0) / farCount : 0};
}

std::vector<double> sortedDistances(const Skeleton& from, const Skeleton& to, double step,
                                    const Progress& progress) {
  std::vector<double> distances = distancesTo(EdgeIndex(to), evenSamples(from, step), progress);
  std::sort(distances.begin(), distances.end());
  return distances;
}

} // namespace

double harmonicMean(double precision, double recall) {
  const double sum = precision + recall;
  return sum > 0 ? 2 * precision * recall / sum : 0;
}

std::vector<double> defaultTolerances(const Skeleton& reference) {
  requireComparable(reference, ComparedAs::reference);
  const double unit = rounded(medianEdgeLength(reference) / 9);
  return {unit, 2 * unit, 4 * unit, 10 * unit};
}

double usualTolerance(const Skeleton& reference) {
  return defaultTolerances(reference)[1];
}

std::vector<double> distancesTo(const EdgeIndex& index, const std::vector<EvenSample>& samples,
                                const Progress& progress) {
  std::vector<double> distances(samples.size());
  parallelFor(
      static_cast<Eigen::Index>(samples.size()),
      [&](Eigen::Index i) {
        const auto sample = static_cast<std::size_t>(i);
        distances[sample] = index.nearest(samples[sample].position)->distance;
      },
      progress);
  return distances;
}

ToleranceCurve toleranceCurve(const Skeleton& result, const Skeleton& reference,
                              const ToleranceOptions& options, const Progress& progress) {
  requireComparable(result, ComparedAs::plant);
  const std::vector<double> rule = defaultTolerances(reference);
  for (const double distance : options.distances)
    if (!(distance >= 0 && std::isfinite(distance)))
      throw ShownError(
          {Shown::tr("tolerance %1: expected a length of 0 or more"), {std::to_string(distance)}});
  ToleranceCurve curve;
  curve.step = options.step > 0 ? options.step : rule.front();
  const auto there = sortedDistances(result, reference, curve.step, progress.part(0, 0.5));
  const auto back = sortedDistances(reference, result, curve.step, progress.part(0.5, 1));
  for (const double distance : options.distances.empty() ? rule : options.distances)
    curve.scores.push_back({.distance = distance,
                            .precision = shareWithin(there, distance),
                            .recall = shareWithin(back, distance)});
  curve.toReference = summary(there, rule.front());
  curve.toResult = summary(back, rule.front());
  return curve;
}

} // namespace espalier
