#pragma once

#include "core/base/progress.h"
#include "core/skeleton/skeleton.h"

#include <cstddef>
#include <string>
#include <vector>

namespace espalier {

/// Scores of a result by which many can be compared. Each is in [0, 1], and 1 for the reference
/// itself, unless it is an error.
enum class Score {
  mapping,          // of authorsComparison()
  geometric,        //
  structural,       //
  structuralOfAll,  //
  oneToMany,        // geometric, of pathMatches()
  cappedGeometric,  // of cappedScores() at the distance
  cappedStructural, // over all segments of the reference
  precision,        // of toleranceCurve() at the distance
  recall,           //
  f,                //
  tips,             // F of landmarkAgreement() at the distance of landmarks
  branchings,       //
  diadem,           // of diademScore() at that distance
  ways,             // pathLengthAgreement().withinTenth at that distance
  order,            // architectureAgreement() at that distance
  axis,             //
  edge,             //

  missedLength,           // of networkAgreement() at both distances: errors in [0, 1]
  inventedLength,         //
  missedConnections,      //
  inventedConnections,    //
  barcode,                // barcodeDistance(): likewise
  substantialToReference, // of toleranceCurve(): errors [L]
  substantialToResult,    //
  concordance,            // of radiusAgreement(), in [-1, 1]; 0 where no radii can be compared
  radiusMeanError,        // of the same: errors [L]; 0 where none can be
  radiusRootMeanSquare    //
};

/// Whether it is 0, not 1, for the reference itself.
[[nodiscard]] bool isError(Score score);

/// What a score is called in files, "structural_of_all", in the order of Score.
[[nodiscard]] const std::vector<std::string>& scoreNames();

struct ScoreOptions {
  double distance = 0;         // [L]; 0 = usualTolerance()
  double landmarkDistance = 0; // [L]; 0 = the reference's median edge
};

/// The options with the lengths that zeros stand for.
/// @throws Error if the reference has no nodes, no length, or a position that is no number
[[nodiscard]] ScoreOptions resolved(const ScoreOptions& options, const Skeleton& reference);

/// All scores of a result, where it lies, in the order of Score.
///
/// @throws Error     if one of the two has no nodes, no length, or a position that is no number
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Cost: see the parts.
[[nodiscard]] std::vector<double> agreementScores(const Skeleton& result, const Skeleton& reference,
                                                  const ScoreOptions& options = {},
                                                  const Progress& progress = {});

} // namespace espalier
