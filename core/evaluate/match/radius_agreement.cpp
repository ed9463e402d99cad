#include "core/evaluate/match/radius_agreement.h"

#include "core/base/parallel.h"
#include "core/evaluate/match/comparable.h"
#include "core/evaluate/match/even_samples.h"
#include "core/skeleton/edge_index.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <vector>

namespace espalier {
namespace {

/// How far up the edge to a node a place on it is, in [0, 1].
double shareOf(const Skeleton& skeleton, NodeId id, const Eigen::Vector3d& place) {
  const Eigen::Vector3d& below = skeleton[*skeleton[id].parent].position;
  return (place - below).norm() / (skeleton[id].position - below).norm();
}

/// The radius at a place on the edge to a node [L]; 0 if an end of it has none.
double radiusAt(const Skeleton& skeleton, NodeId id, const Eigen::Vector3d& place) {
  const Node& node = skeleton[id];
  if (!node.parent) return node.radius;
  const Node& below = skeleton[*node.parent];
  if (!(node.radius > 0 && below.radius > 0) || node.position == below.position) return 0;
  return std::lerp(below.radius, node.radius, shareOf(skeleton, id, place));
}

struct RadiusPair {
  double result = 0; // [L]; 0: they cannot be compared
  double reference = 0;
  NearestPlace place{}; // of the reference
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
                              radiusAt(reference, nearest.node, nearest.position), nearest};
        if (pair.result > 0 && pair.reference > 0) pairs[static_cast<std::size_t>(i)] = pair;
      },
      progress);
  std::erase_if(pairs, [](const RadiusPair& pair) { return pair.result == 0; });
  return pairs;
}

/// The coverage at a place, between those of the ends of its edge.
double coverageAt(const Skeleton& reference, const std::vector<double>& coverages,
                  const NearestPlace& place) {
  const double upper = coverages[indexOf(place.node)];
  const std::optional<NodeId>& parent = reference[place.node].parent;
  if (!parent) return upper;
  return std::lerp(coverages[indexOf(*parent)], upper,
                   shareOf(reference, place.node, place.position));
}

/// @param length [L], that each pair stands for
std::vector<RadiusByArc> errorsByArc(const Skeleton& reference,
                                     const std::vector<RadiusPair>& pairs, double length,
                                     const std::vector<double>& coverages) {
  constexpr std::size_t classes = 4;
  std::array<std::vector<const RadiusPair*>, classes> in;
  for (const RadiusPair& pair : pairs) {
    const double share = coverageAt(reference, coverages, pair.place);
    in[std::min(classes - 1, static_cast<std::size_t>(share * classes))].push_back(&pair);
  }
  std::vector<RadiusByArc> errors;
  for (std::size_t k = 0; k < classes; ++k) {
    const auto count = static_cast<double>(in[k].size());
    RadiusByArc error{.from = static_cast<double>(k) / classes,
                      .to = static_cast<double>(k + 1) / classes,
                      .compared = length * count};
    for (const RadiusPair* pair : in[k]) {
      const double off = pair->result - pair->reference;
      error.meanError += off / count;
      error.rootMeanSquare += off * off / count;
      error.relativeRootMeanSquare += std::pow(off / pair->reference, 2) / count;
    }
    error.rootMeanSquare = std::sqrt(error.rootMeanSquare);
    error.relativeRootMeanSquare = std::sqrt(error.relativeRootMeanSquare);
    errors.push_back(error);
  }
  return errors;
}

} // namespace

RadiusAgreement radiusAgreement(const Skeleton& result, const Skeleton& reference, double distance,
                                double step, const std::vector<double>& coverages,
                                const Progress& progress) {
  assert(distance > 0 && step > 0);
  assert(coverages.empty() || coverages.size() == reference.idEnd());
  requireComparable(result, ComparedAs::plant);
  requireComparable(reference, ComparedAs::reference);
  const std::vector<EvenSample> samples = evenSamples(result, step);
  const std::vector<RadiusPair> pairs = radiusPairs(result, reference, samples, distance, progress);
  RadiusAgreement agreement{.distance = distance};
  if (pairs.empty()) return agreement;
  const auto count = static_cast<double>(pairs.size());
  const double length = totalLength(result) / static_cast<double>(samples.size());
  agreement.compared = length * count;
  if (!coverages.empty()) agreement.byArc = errorsByArc(reference, pairs, length, coverages);
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
