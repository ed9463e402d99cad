#pragma once

#include "core/base/progress.h"
#include "core/evaluate/match/even_samples.h"
#include "core/skeleton/edge_index.h"
#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier {

struct ToleranceOptions {
  std::vector<double> distances; // [L], >= 0; empty = defaultTolerances
  double step = 0;               // [L] between samples; 0 = the least of defaultTolerances
};

/// Harmonic mean of two shares; 0 if both are.
[[nodiscard]] double harmonicMean(double precision, double recall);

/// How much of two skeletons lies near the other.
struct ToleranceScore {
  double distance;  // [L], the tolerance
  double precision; // in [0, 1]: share of the result's length that is near the reference
  double recall;    // in [0, 1]: share of the reference's length that is near the result
  [[nodiscard]] double f() const { return harmonicMean(precision, recall); }
};

/// Distances from one skeleton to the other, over its length [L].
struct DistanceSummary {
  double mean = 0;         // one side of the Chamfer distance
  double percentile95 = 0; // 95 % of the length is at most this far: the robust Hausdorff distance
  double farShare = 0;     // in [0, 1]: of the length that is over the finest default tolerance off
  double farMean = 0;      // over that length: the substantial distance of neuron tools; 0 if none
};

struct ToleranceCurve {
  double step = 0;                    // [L], as used
  std::vector<ToleranceScore> scores; // by the distances asked for
  DistanceSummary toReference;        // from places of the result
  DistanceSummary toResult;           // from places of the reference
};

/// Tolerances that suit a reference: 1, 2, 4 and 10 times a ninth of its median edge, that ninth
/// rounded to one decimal digit so that people read round numbers and mm or m make no difference.
/// The pine of the thesis has a median edge of 44.4 mm, hence 5, 10, 20 and 50 mm.
[[nodiscard]] std::vector<double> defaultTolerances(const Skeleton& reference);

/// The tolerance that scores go by unless another is given: the second of defaultTolerances(), 10
/// mm for the pine. Finer, noise decides; coarser, twigs beside each other are taken for one.
[[nodiscard]] double usualTolerance(const Skeleton& reference); // [L]

/// Distance from each sample to the nearest place of a skeleton [L].
/// pre: the indexed skeleton is not empty. @throws Cancelled if `progress` asks to stop
[[nodiscard]] std::vector<double> distancesTo(const EdgeIndex& index,
                                              const std::vector<EvenSample>& samples,
                                              const Progress& progress = {});

/// Precision, recall and F over tolerances, Chamfer and 95 % Hausdorff distances.
///
/// Both skeletons are sampled at even steps; from each sample the distance to the nearest place of
/// the other, on its edges and not only its samples, is taken. So the scores depend neither on
/// where nodes lie along an edge nor, but for the step, on sampling. Nothing is registered first.
///
/// @throws Error     if one of the two has no nodes, no length, or a position that is no number;
///                   if a tolerance is negative or no number
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O((N + samples) log N), memory O(N + samples).
[[nodiscard]] ToleranceCurve toleranceCurve(const Skeleton& result, const Skeleton& reference,
                                            const ToleranceOptions& options = {},
                                            const Progress& progress = {});

} // namespace espalier
