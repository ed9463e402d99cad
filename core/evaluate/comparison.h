#pragma once

#include "core/base/progress.h"
#include "core/base/shown_message.h"
#include "core/evaluate/differences/differences.h"
#include "core/evaluate/light/light_interception.h"
#include "core/evaluate/match/agreement_by_place.h"
#include "core/evaluate/match/architecture_agreement.h"
#include "core/evaluate/match/authors_comparison.h"
#include "core/evaluate/match/capped_scores.h"
#include "core/evaluate/match/diadem_score.h"
#include "core/evaluate/match/edit_comparison.h"
#include "core/evaluate/match/landmark_agreement.h"
#include "core/evaluate/match/network_agreement.h"
#include "core/evaluate/match/path_length_agreement.h"
#include "core/evaluate/match/path_matches.h"
#include "core/evaluate/match/radius_agreement.h"
#include "core/evaluate/match/tolerance_curve.h"
#include "core/evaluate/registration/registration.h"
#include "core/evaluate/scan_sight.h"
#include "core/evaluate/scores.h"
#include "core/evaluate/traits/breast_height.h"
#include "core/evaluate/traits/traits.h"
#include "core/evaluate/traits/wood_amounts.h"
#include "core/skeleton/skeleton.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace espalier {

struct ComparisonOptions {
  bool registers = true;            // lays the result on the reference before anything is measured
  RegistrationOptions registration; // its `up` is the axis along which heights are measured, too
  AuthorsOptions authors;
  EditOptions edit;
  ToleranceOptions tolerance;
  double placeDistance = 0;    // [L], for the agreement by place; 0 = usualTolerance()
  double landmarkDistance = 0; // [L], for tips and branchings; 0 = the reference's median edge
  double breastHeight = 0;     // [L], as breastHeightIn(); 0: its diameter is not measured
  std::optional<LightOptions> light; // none: it is not measured
  EvaluatedScan scan;                // without points: no errors by the arc that was seen
  /// By id of the reference, found before from that scan; null: they are found.
  std::shared_ptr<const std::vector<double>> coverages;
  /// Found before, at `placeDistance`; outlive the comparison; null: they are found.
  const Differences* differences = nullptr;
  /// How the result was laid on the reference before: reported as its shift and turn.
  std::optional<Registration> laidBefore = {};
};

/// The scores that take a distance, at one.
struct ScoresAt {
  double distance = 0; // [L]
  ScoreValues values;
};

/// All that says how a result agrees with its reference.
struct Comparison {
  std::optional<Registration> registration; // none if it was not asked for
  ScoreValues scores;                       // all, at the distance of `byPlace`
  std::vector<ScoresAt> scoresAt;           // by the distances of `tolerance`
  AuthorsComparison authors;
  PathMatches paths;                  // of `authors`, one to many
  std::vector<CappedScore> capped;    // by the distances of `tolerance`
  std::optional<EditComparison> edit; // none between plants of over `mostEditedPairs`
  ToleranceCurve tolerance;
  LandmarkAgreement tips;
  LandmarkAgreement branchings;
  DiademScore diadem; // these three within the distance of the landmarks
  PathLengthAgreement pathLengths;
  NetworkAgreement network;   // by the distance of `byPlace`, and that of the landmarks
  double barcodeDistance = 0; // in [0, 1], of the barcodes of both
  RadiusAgreement radii;      // within the distance of the landmarks
  std::shared_ptr<const std::vector<double>> coverages; // as used; null: not known
  StemDiameters stems;
  ArchitectureAgreement architecture;
  AgreementByPlace byPlace;
  Differences differences; // at the distance of `byPlace`
  Traits resultTraits;
  Traits referenceTraits;
  WoodAmounts resultWood;
  WoodAmounts referenceWood;
  std::optional<LightInterception> resultLight; // of generalized cylinders; none if not asked for,
  std::optional<LightInterception> referenceLight; // or if no node has a radius
  std::vector<double> radiusLimits;   // of the classes of both [L]: those of the reference
  std::vector<ShownMessage> warnings; // a line each: what makes the numbers doubtful
  ShownMessage shiftWarning;          // the one of them about the shift; empty if there is none
};

/// Pairs of parts of both plants up to which compare() computes the edit distance: a few seconds.
inline constexpr std::size_t mostEditedPairs = 25'000'000;

/// Compares a result with its reference: registration, then all scores and what they come from on
/// the registered result, agreement by place, and the traits and the wood of both.
///
/// Warns if the two lie apart by more than the finest default tolerance or were turned, if one is
/// of several trees, if one is as much larger as a unit is than another, or over 20 times, and if
/// little or hardly anything of the two lies near.
///
/// @throws Error     if one of the two has no nodes, no length, or a position that is no number
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Cost: see the parts.
[[nodiscard]] Comparison compare(const Skeleton& result, const Skeleton& reference,
                                 const ComparisonOptions& options = {},
                                 const Progress& progress = {});

} // namespace espalier
