#pragma once

#include "core/base/progress.h"
#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier {

/// Errors of radii where the scanner saw some share of the way around the wood.
struct RadiusByArc {
  double from = 0; // that share, in [from, to); the last holds 1, too
  double to = 1;
  double compared = 0;               // [L], length of the result; 0: there is none
  double meanError = 0;              // [L], result less reference
  double rootMeanSquare = 0;         // [L], of the same
  double relativeRootMeanSquare = 0; // of the same, in radii of the reference
};

/// How the radii of a result agree with those of its reference, over the length where both have
/// one and lie near each other.
struct RadiusAgreement {
  double distance = 0;       // [L], what is called near
  double compared = 0;       // [L], length of the result; 0: nothing could be compared
  double meanError = 0;      // [L], result less reference
  double rootMeanSquare = 0; // [L], of the same
  /// Lin's concordance, in [-1, 1]: 1 where all radii are the same; unlike a correlation it falls
  /// with an error of all of them alike.
  double concordance = 0;
  std::vector<RadiusByArc> byArc; // in quarters of the way around; empty if it is not known
};

/// Compares the radius at even samples of the result with that at the nearest place of the
/// reference; radii change evenly along an edge.
///
/// @param distance  [L], > 0
/// @param step      [L], > 0, between samples
/// @param coverages by id of the reference, as arcCoverages(); empty: not known
/// @throws Error     if one of the two has no nodes, no length, or a position that is no number
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O((N + samples) log N).
/// Source: L. I.-K. Lin, "A concordance correlation coefficient to evaluate reproducibility",
/// Biometrics 45, 1989.
[[nodiscard]] RadiusAgreement radiusAgreement(const Skeleton& result, const Skeleton& reference,
                                              double distance, double step,
                                              const std::vector<double>& coverages = {},
                                              const Progress& progress = {});

} // namespace espalier
