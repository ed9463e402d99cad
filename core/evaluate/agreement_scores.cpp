#include "core/evaluate/agreement_scores.h"

#include "core/evaluate/architecture_agreement.h"
#include "core/evaluate/authors_comparison.h"
#include "core/evaluate/barcode.h"
#include "core/evaluate/capped_scores.h"
#include "core/evaluate/comparable.h"
#include "core/evaluate/diadem_score.h"
#include "core/evaluate/landmark_agreement.h"
#include "core/evaluate/network_agreement.h"
#include "core/evaluate/path_length_agreement.h"
#include "core/evaluate/path_matches.h"
#include "core/evaluate/radius_agreement.h"
#include "core/evaluate/tolerance_curve.h"
#include "core/evaluate/traits.h"

namespace espalier {

const std::vector<std::string>& scoreNames() {
  static const std::vector<std::string> names = {"mapping",
                                                 "geometric",
                                                 "structural",
                                                 "structural_of_all",
                                                 "one_to_many",
                                                 "capped_geometric",
                                                 "capped_structural",
                                                 "precision",
                                                 "recall",
                                                 "f",
                                                 "tips",
                                                 "branchings",
                                                 "diadem",
                                                 "ways",
                                                 "order",
                                                 "axis",
                                                 "edge",
                                                 "missed_length",
                                                 "invented_length",
                                                 "missed_connections",
                                                 "invented_connections",
                                                 "barcode",
                                                 "substantial_to_reference",
                                                 "substantial_to_result",
                                                 "concordance",
                                                 "radius_mean_error",
                                                 "radius_root_mean_square"};
  return names;
}

bool isError(Score score) {
  return score > Score::edge && score != Score::concordance;
}

ScoreOptions resolved(const ScoreOptions& options, const Skeleton& reference) {
  ScoreOptions result = options;
  if (result.distance <= 0) result.distance = usualTolerance(reference);
  if (result.landmarkDistance <= 0) result.landmarkDistance = medianEdgeLength(reference);
  return result;
}

std::vector<double> agreementScores(const Skeleton& result, const Skeleton& reference,
                                    const ScoreOptions& options, const Progress& progress) {
  const auto [distance, landmarkDistance] = resolved(options, reference);
  const double step = defaultTolerances(reference).front();
  const AuthorsComparison authors = authorsComparison(result, reference, {}, progress.part(0, 0.2));
  const CappedScore capped =
      cappedScores(result, reference, {.distances = {distance}, .step = step},
                   progress.part(0.2, 0.4))
          .front();
  const ToleranceCurve curve = toleranceCurve(
      result, reference, {.distances = {distance}, .step = step}, progress.part(0.4, 0.7));
  const ToleranceScore& near = curve.scores.front();
  const NetworkAgreement network = networkAgreement(
      result, reference, {.deviation = distance, .distance = landmarkDistance, .step = step},
      progress.part(0.7, 0.75));
  const RadiusAgreement radii =
      radiusAgreement(result, reference, landmarkDistance, step, {}, progress.part(0.75, 0.8));
  const PathLengthAgreement ways = pathLengthAgreement(
      result, reference, {.distance = landmarkDistance, .step = step}, progress.part(0.8, 0.9));
  const ArchitectureAgreement architecture = architectureAgreement(
      result, reference, authors, landmarkDistance, step, progress.part(0.9, 1));
  return {authors.mapping,
          authors.geometric,
          authors.structural,
          authors.structuralOfAll,
          pathMatches(authors).geometric,
          capped.geometric,
          capped.structuralOfAll,
          near.precision,
          near.recall,
          near.f(),
          landmarkAgreement(tips(result), tips(reference), landmarkDistance).f(),
          landmarkAgreement(branchings(result), branchings(reference), landmarkDistance).f(),
          diademScore(result, reference, {.distance = landmarkDistance}).score,
          ways.withinTenth,
          architecture.sameOrder,
          architecture.sameAxis,
          architecture.types.observed(),
          network.missedLength,
          network.inventedLength,
          network.missedConnections,
          network.inventedConnections,
          barcodeDistance(barcode(result), barcode(reference)),
          curve.toReference.farMean,
          curve.toResult.farMean,
          radii.concordance,
          radii.meanError,
          radii.rootMeanSquare};
}

} // namespace espalier
