#pragma once

#include "core/base/progress.h"
#include "core/evaluate/match/segment_matches.h"
#include "core/skeleton/skeleton.h"

#include <cstddef>
#include <vector>

namespace espalier {

struct CappedOptions {
  std::vector<double> distances; // [L], > 0; empty = defaultTolerances
  double step = 0;               // [L] between places of a segment; 0 = the least of these
};

/// The authors' indices where no pair may lie further apart than some distance.
struct CappedScore {
  double distance = 0;           // [L], the farthest
  std::size_t matched = 0;       // pairs of segments
  double mapping = 0;            // in [0, 1]: share of the segments of both that are matched
  double geometric = 0;          // in [0, 1]: share of the length of both that is matched
  double structural = 0;         // in [0, 1]: share of the matches that are conserved
  double structuralOfAll = 0;    // in [0, 1]: conserved matches per segment of the reference
  Partners partners;             // by segment of the result, as of unbranchedSegments()
  std::vector<bool> isConserved; // likewise
};

/// The indices of authorsComparison() with what they hide taken away.
///
/// A pair costs the Hausdorff distance of the two segments as curves, not of their nodes, and is
/// allowed up to the distance asked for; leaving a segment of the reference alone costs twice its
/// length, leaving one of the result alone costs nothing. So noise, which lengthens the result,
/// does not pay for itself, and where nodes lie along an edge does not matter.
///
/// @return a score per distance, in their order
/// @throws Error     if one of the two has no nodes, no length, or a position that is no number;
///                   if a distance is not above 0
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O((R + S) log R + pairs within the largest distance), memory the same.
[[nodiscard]] std::vector<CappedScore> cappedScores(const Skeleton& result,
                                                    const Skeleton& reference,
                                                    const CappedOptions& options = {},
                                                    const Progress& progress = {});

} // namespace espalier
