#pragma once

#include "core/base/progress.h"
#include "core/evaluate/match/segments.h"
#include "core/skeleton/skeleton.h"

#include <cstddef>
#include <vector>

namespace espalier {

struct AuthorsOptions {
  /// [L] Boxes of two segments at most this far apart make the segments candidates; 0 = the
  /// authors' rule: twice the mean edge length of the segment that continues the first segment
  /// of the reference (its successor, else its first branch).
  double boxDistance = 0;
};

/// How well a result agrees with a reference by the measure of the method's authors.
struct AuthorsComparison {
  struct Match {
    std::size_t result;    // in resultSegments
    std::size_t reference; // in referenceSegments
    double cost;           // Hausdorff distance of the two [L]
    bool isConserved;      // the nearest matched segments below both are matched to each other
  };

  std::vector<Segment> resultSegments;
  std::vector<Segment> referenceSegments;
  double boxDistance = 0;     // [L], as used
  std::size_t candidates = 0; // pairs of segments whose boxes are that near
  std::vector<Match> matches; // by result segment
  double cost = 0;            // of the assignment, segments left alone included [L]
  double mapping = 0;         // in [0, 1]: share of the segments of both that are matched
  double geometric = 0;       // G, in [0, 1]: share of the length of both that is matched
  double structural = 0;      // T, in [0, 1]: share of the matches that are conserved
  double structuralOfAll = 0; // in [0, 1]: conserved matches per segment of the reference
  double lengthPrecision = 0; // in [0, 1]: share of the result's length that is matched
  double lengthRecall = 0;    // in [0, 1]: share of the reference's length that is matched
};

/// Compares two skeletons as the authors of the method did: unbranched segments are assigned one
/// to one so that Hausdorff distances of pairs plus lengths of segments left alone are least.
///
/// Nothing is registered or resampled first: shifted frames and other node spacings count.
/// Radii and edge types are not used. Weaknesses: G hardly falls with position noise, because
/// noise also lengthens what it costs to leave a segment alone, for which see cappedScores(); T is
/// over matches only, so `structuralOfAll` is not the authors'.
/// Differs from the authors where segments have no length: pairs at no distance stay candidates,
/// and a rule that gives no distance falls back on twice the median edge of the reference.
///
/// @throws Error     if one of the two has no nodes, no length, or a position that is no number
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O((R + S) log R + candidates), memory the same.
/// Source: F. Boudon et al., "Reconstruction of plant architecture from 3D laser scanner data",
/// Annals of Botany 114, 2014; C. Preuksakarn's thesis, 5.5; their program tree_matching.
[[nodiscard]] AuthorsComparison authorsComparison(const Skeleton& result, const Skeleton& reference,
                                                  const AuthorsOptions& options = {},
                                                  const Progress& progress = {});

} // namespace espalier
