#include "core/radius/length_pipe_model.h"

#include "core/skeleton/length_along.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace espalier {
namespace {

double medianOf(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// [L]; the mean where most edges have next to no length, 1 where none has any.
double medianEdge(const Skeleton& skeleton) {
  constexpr double negligible = 1e-9; // of the mean
  std::vector<double> lengths;
  double sum = 0;
  for (const NodeId id : skeleton.ids())
    if (const auto parent = skeleton[id].parent) {
      lengths.push_back((skeleton[id].position - skeleton[*parent].position).norm());
      sum += lengths.back();
    }
  if (!(sum > 0)) return 1;
  const double mean = sum / static_cast<double>(lengths.size());
  const double median = medianOf(lengths);
  return median > negligible * mean ? median : mean;
}

/// A measured radius over what its node carries.
struct Sample {
  double carried = 0;   // [L]
  double logRadius = 0; // of a radius in [L]
  double weight = 0;
};

std::vector<Sample> samplesOf(const Skeleton& skeleton,
                              const std::vector<MeasuredRadius>& measured) {
  constexpr double leastDeviation = 1e-6; // or sums of weights may overflow
  const std::vector<double> carried = carriedLengths(skeleton);
  std::vector<Sample> samples;
  for (const NodeId id : skeleton.ids()) {
    const MeasuredRadius& each = measured[indexOf(id)];
    if (each.radius > 0 && std::isfinite(each.radius) && each.deviation > 0)
      samples.push_back({carried[indexOf(id)], std::log(each.radius),
                         1 / std::max(each.deviation, leastDeviation)});
  }
  return samples;
}

/// A line through logarithms: y = height + slope * x.
struct Line {
  double height = 0;
  double slope = 0;
  double cost = std::numeric_limits<double>::infinity(); // mean absolute distance
};

/// The line with the least weighted sum of absolute distances, its slope held to [0, 1].
Line leastDistances(const std::vector<Sample>& samples, double tipLength) {
  constexpr double least = 1e-3; // nearer than this all count alike
  constexpr int rounds = 20;
  std::vector<double> shares(samples.size(), 1);
  Line line;
  for (int round = 0; round < rounds; ++round) {
    double n = 0;
    double x1 = 0;
    double y1 = 0;
    double xx = 0;
    double xy = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double weight = samples[i].weight * shares[i];
      const double x = std::log(samples[i].carried + tipLength);
      n += weight;
      x1 += weight * x;
      y1 += weight * samples[i].logRadius;
      xx += weight * x * x;
      xy += weight * x * samples[i].logRadius;
    }
    const double wide = n * xx - x1 * x1;
    if (!(wide > 1e-9 * n * xx)) return {};
    line.slope = std::clamp((n * xy - x1 * y1) / wide, 0.0, 1.0);
    line.height = (y1 - line.slope * x1) / n;
    double cost = 0;
    double all = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double x = std::log(samples[i].carried + tipLength);
      const double off = std::abs(samples[i].logRadius - line.height - line.slope * x);
      cost += samples[i].weight * off;
      all += samples[i].weight;
      shares[i] = 1 / std::max(off, least);
    }
    line.cost = cost / all;
  }
  return line;
}

} // namespace

double LengthPipeModel::radius(double carried) const {
  return scale * std::pow(carried + tipLength, exponent);
}

LengthPipeModel lengthPipeThrough(const Skeleton& skeleton, double rootRadius, double apexRadius) {
  const double edge = medianEdge(skeleton);
  double heaviest = 0;
  for (const double carried : carriedLengths(skeleton))
    heaviest = std::max(heaviest, carried);
  const double exponent = heaviest > 0 && apexRadius > 0 ? std::log(rootRadius / apexRadius) /
                                                               std::log((heaviest + edge) / edge)
                                                         : 0;
  return {.scale = apexRadius / std::pow(edge, exponent),
          .tipLength = edge,
          .exponent = exponent,
          .spread = 0};
}

std::optional<LengthPipeModel> fittedLengthPipe(const Skeleton& skeleton,
                                                const std::vector<MeasuredRadius>& measured) {
  constexpr std::size_t fewest = 8;
  std::vector<Sample> samples = samplesOf(skeleton, measured);
  if (samples.size() < fewest) return std::nullopt;
  const double edge = medianEdge(skeleton);
  Line best;
  double tipLength = edge;
  constexpr int trials = 10;
  double trial = edge / 4;
  for (int i = 0; i < trials; ++i, trial *= 2) {
    const Line line = leastDistances(samples, trial);
    if (line.cost >= best.cost) continue;
    best = line;
    tipLength = trial;
  }
  if (!std::isfinite(best.cost)) return std::nullopt;
  std::vector<double> distances;
  distances.reserve(samples.size());
  for (const Sample& sample : samples)
    distances.push_back(std::abs(sample.logRadius - best.height -
                                 best.slope * std::log(sample.carried + tipLength)));
  constexpr double deviation = 1.4826; // per median distance
  return LengthPipeModel{.scale = std::exp(best.height),
                         .tipLength = tipLength,
                         .exponent = best.slope,
                         .spread = deviation * medianOf(distances)};
}

std::vector<double> radiiOf(const Skeleton& skeleton, const LengthPipeModel& model) {
  std::vector<double> radii = carriedLengths(skeleton);
  for (double& radius : radii)
    radius = model.radius(radius);
  return radii;
}

std::vector<double> averagePipeRadii(const Skeleton& skeleton, double meanRadius, double exponent) {
  const double edge = medianEdge(skeleton);
  std::vector<double> weights = carriedLengths(skeleton);
  double heaviest = 0;
  for (double& weight : weights) {
    weight = std::log1p(weight / edge + 0.5);
    heaviest = std::max(heaviest, weight);
  }
  double sum = 0;
  double all = 0;
  for (const NodeId id : skeleton.ids()) {
    const double weight = weights[indexOf(id)];
    sum += weight * std::pow(weight / heaviest, exponent);
    all += weight;
  }
  std::vector<double> radii(weights.size(), 0);
  for (const NodeId id : skeleton.ids())
    radii[indexOf(id)] =
        meanRadius * all / sum * std::pow(weights[indexOf(id)] / heaviest, exponent);
  return radii;
}

} // namespace espalier
