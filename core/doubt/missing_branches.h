#pragma once

#include "core/base/progress.h"
#include "core/base/quadratic.h"
#include "core/decide/end_evidence.h"
#include "core/doubt/doubt_sources.h"
#include "core/pipeline/attach_grown.h"

#include <array>
#include <vector>

namespace espalier {

/// A branch that points without wood may be.
struct MissingBranch {
  GrownBranch branch;
  EndEvidence evidence; // as of an end of the plant, if it were added with all others
  double gap = 0;       // spacings from the surface of what would bear it to its first new node
  double share = 0;     // branches that may be missing, by ends of the plant
  double ends = 0;      // of the plant
};

/// A branch traced along each cluster of points that have no wood, attached as it may have grown.
/// Of its ends it has those that are probably shoots, and at least the most probable one: the
/// points of leaves would make many.
///
/// Uses all threads, deterministic. Time O(N log N), and a trace for each cluster.
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] std::vector<MissingBranch> missingBranches(const Skeleton& skeleton,
                                                         const DoubtSources& sources,
                                                         const Progress& progress = {});

/// What the probability of a missing branch follows from: what an end's does, where it would begin,
/// how many there are, and what all ends of the plant are like.
[[nodiscard]] std::array<double, 15> featuresOf(const MissingBranch& missing);

/// Whose value is the logarithm of the odds, as OddsAmongAll.
using MissingOdds = WholeQuadratic<15>;

/// The odds that are fitted: by espalier_fit_missing (tests/bench/fit_missing.cpp) on simulated
/// scans.
[[nodiscard]] const MissingOdds& fittedMissingOdds();

/// How probable it is, in (0, 1), that there is wood, which no other wood of the plant stands for.
[[nodiscard]] double probabilityOfWood(const MissingBranch& missing,
                                       const MissingOdds& odds = fittedMissingOdds());

} // namespace espalier
