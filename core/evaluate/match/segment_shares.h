#pragma once

#include "core/base/progress.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

namespace espalier {

/// What each segment of a reference brings to the scores of a result. Scores are ratios of the sums
/// of these, so that a sum over other segments gives the scores of another such plant.
enum class Share {
  resultLength,     // of segments of the result that belong to this one [L]
  referenceLength,  // of this one [L]
  matchedResult,    // of resultLength, by authorsComparison() [L]
  matchedReference, // of referenceLength, likewise [L]
  matches,          // 1 if it is matched, else 0
  conserved,        // 1 if that match is conserved, else 0
  cappedResult,     // as matchedResult, by cappedScores() [L]
  cappedReference,  // as matchedReference, likewise [L]
  cappedConserved,  // as conserved, likewise
  nearResult,       // length of the result nearest to this one and within the distance [L]
  allResult,        // length of the result nearest to this one [L]
  nearReference,    // length of samples of this one within the distance of the result [L]
  allReference,     // length of samples of this one: referenceLength but for rounding [L]
  segments,         // 1
  count             // of shares
};

inline constexpr auto shareCount = static_cast<Eigen::Index>(Share::count);

using SegmentShares = Eigen::Matrix<double, shareCount, Eigen::Dynamic>; // a column per segment
using ShareSums = Eigen::Matrix<double, shareCount, 1>;

/// The shares of the segments of the reference, as of unbranchedSegments().
///
/// A segment of the result belongs to the one it is matched with, else to the one that its middle
/// is nearest to.
/// @param distance [L], > 0, for the capped and the near ones
/// @param step     [L] between samples, > 0
/// @throws Error     if one of the two has no nodes, no length, or a position that is no number
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Cost: authorsComparison(), cappedScores() and toleranceCurve().
[[nodiscard]] SegmentShares segmentShares(const Skeleton& result, const Skeleton& reference,
                                          double distance, double step,
                                          const Progress& progress = {});

} // namespace espalier
