#include "core/evaluate/radius_agreement.h"

#include "core/base/parallel.h"
#include "core/evaluate/comparable.h"
#include "core/evaluate/edge_index.h"
#include "core/evaluate/even_samples.h"

#include <cassert>
#include <cmath>
#include <vector>

namespace espalier {
namespace {

/// The radius at a place on the edge to a node [L]; 0 if an end of it has none.
double radiusAt(const Skeleton& skeleton, NodeId id, const Eigen::Vector3d& place) {
  const Node& node = skeleton[id];
  if (!node.parent) return node.radius;
  const Node& below = skeleton[*node.parent];
  const double length = (node.position - below.position).norm();
  if (!(node.radius > 0 && below.radius > 0) || length == 0) return 0;
  return std::lerp(below.radius, node.radius, (place - below.position).norm() / length);
}

struct RadiusPair {
  double result = 0; // [L]; 0: they cannot be compared
  double reference = 0;
};

std::vector<RadiusPair> radiusPairs(const Skeleton& result, const Skeleton& reference,
                                    const std::vector<EvenSample>& samples, double distance,
                                    const Progress& progress) {
  const EdgeIndex index(reference);
  std::vector<RadiusPair> pairs(samples.size());
  parallelFor(
      static_cast<Eigen::Index>(samples.size()),
      [&](Eigen::Index i) {
        const EvenSample& sample = samples[static_cast<std::size_t>(i)];
        const NearestPlace nearest = *index.nearest(sample.position);
        if (nearest.distance > distance) return;
        const RadiusPair pair{radiusAt(result, sample.node, sample.position),
                              radiusAt(reference, nearest.node, nearest.position)};
        if (pair.result > 0 && pair.reference > 0) pairs[static_cast<std::size_t>(i)] = pair;
      },
      progress);
  std::erase_if(pairs, [](const RadiusPair& pair) { return pair.result == 0; });
  return pairs;
}

} // namespace

RadiusAgreement radiusAgreement(const Skeleton& result, const Skeleton& reference, double distance,
                                double step, const Progress& progress) {
  assert(distance > 0 && step > 0);
  requireComparable(result, "the result");
  requireComparable(reference, "the reference");
  const std::vector<EvenSample> samples = evenSamples(result, step);
  const std::vector<RadiusPair> pairs = radiusPairs(result, reference, samples, distance, progress);
  RadiusAgreement agreement{.distance = distance};
  if (pairs.empty()) return agreement;
  const auto count = static_cast<double>(pairs.size());
  agreement.compared = totalLength(result) * count / static_cast<double>(samples.size());
  RadiusPair mean;
  for (const RadiusPair& pair : pairs) {
    mean.result += pair.result / count;
    mean.reference += pair.reference / count;
    agreement.rootMeanSquare += std::pow(pair.result - pair.reference, 2) / count;
  }
  double variances = 0;
  double covariance = 0;
  for (const RadiusPair& pair : pairs) {
    const double x = pair.result - mean.result;
    const double y = pair.reference - mean.reference;
    variances += (x * x + y * y) / count;
    covariance += x * y / count;
  }
  agreement.meanError = mean.result - mean.reference;
  agreement.rootMeanSquare = std::sqrt(agreement.rootMeanSquare);
  const double apart = variances + agreement.meanError * agreement.meanError;
  agreement.concordance = apart > 0 ? 2 * covariance / apart : 1;
  return agreement;
}

} // namespace espalier
