#pragma once

#include "core/base/progress.h"
#include "core/evaluate/comparison.h"
#include "core/evaluate/differences/differences.h"
#include "core/skeleton/skeleton.h"

#include <optional>

namespace espalier {

/// Two plants where they lie, and what they are compared in: each is made when it is first asked
/// for, and kept. All scores are computed from it.
class ComparedPlants {
public:
  /// @param result laid on the reference before; the two outlive this
  ComparedPlants(const Skeleton& result, const Skeleton& reference,
                 const ComparisonOptions& options = {}, const Progress& progress = {});

  /// The progress of what is made next.
  ComparedPlants& with(const Progress& progress);
  /// Goes on at another of the distances of the options: near() and capped() follow it, network()
  /// and differences() stay those of the first.
  void goTo(double distance) { distance_ = distance; }

  [[nodiscard]] const Skeleton& result() const { return result_; }
  [[nodiscard]] const Skeleton& reference() const { return reference_; }
  [[nodiscard]] double distance() const { return distance_; }                 // [L], what is near
  [[nodiscard]] double landmarkDistance() const { return landmarkDistance_; } // [L]
  [[nodiscard]] double step() const { return step_; }                         // [L] between samples

  /// How the result was laid on the reference; none if it was not.
  [[nodiscard]] const std::optional<Registration>& registration() const;
  const AuthorsComparison& authors();
  const PathMatches& paths();
  const ToleranceCurve& tolerance();
  const ToleranceScore* near(); // at the distance; null if it is none of the options'
  const CappedScore* capped();  // at the distance; null as above
  const std::optional<EditComparison>& edit(); // none between plants of over `mostEditedPairs`
  const LandmarkAgreement& tips();
  const LandmarkAgreement& branchings();
  const DiademScore& diadem();
  const PathLengthAgreement& pathLengths();
  const NetworkAgreement& network();
  double barcodeDistance();
  const RadiusAgreement& radii();
  const StemDiameters& stems();
  const ArchitectureAgreement& architecture();
  const Differences& differences();

  /// Makes all that a Comparison holds of these, and moves it there.
  void moveTo(Comparison& comparison) &&;

private:
  const std::vector<CappedScore>& allCapped(); // by the distances above 0

  const Skeleton& result_;
  const Skeleton& reference_;
  ComparisonOptions options_;
  Progress progress_;
  double distance_;
  double landmarkDistance_;
  double step_;

  std::optional<AuthorsComparison> authors_;
  std::optional<PathMatches> paths_;
  std::optional<ToleranceCurve> tolerance_;
  std::optional<std::vector<CappedScore>> capped_;
  std::optional<std::optional<EditComparison>> edit_;
  std::optional<LandmarkAgreement> tips_;
  std::optional<LandmarkAgreement> branchings_;
  std::optional<DiademScore> diadem_;
  std::optional<PathLengthAgreement> pathLengths_;
  std::optional<NetworkAgreement> network_;
  std::optional<double> barcodeDistance_;
  std::optional<RadiusAgreement> radii_;
  std::optional<StemDiameters> stems_;
  std::optional<ArchitectureAgreement> architecture_;
  std::optional<Differences> differences_;
};

struct ScoreOptions {
  double distance = 0;         // [L]; 0 = usualTolerance()
  double landmarkDistance = 0; // [L]; 0 = the reference's median edge
};

/// The options with the lengths that zeros stand for.
/// @throws Error if the reference has no nodes, no length, or a position that is no number
[[nodiscard]] ScoreOptions resolved(const ScoreOptions& options, const Skeleton& reference);

/// By key, the scores that studies and sweeps write of a result where it lies; 0 for those that
/// cannot be computed.
///
/// @throws Error     if one of the two has no nodes, no length, or a position that is no number
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Cost: see the parts.
[[nodiscard]] std::map<std::string, double> studyScores(const Skeleton& result,
                                                        const Skeleton& reference,
                                                        const ScoreOptions& options = {},
                                                        const Progress& progress = {});

/// Pairs of parts of both that an edit distance compares.
struct EditedParts {
  std::size_t result = 0;
  std::size_t reference = 0;
};
[[nodiscard]] EditedParts editedParts(const ComparedPlants& plants, EditUnit unit);

} // namespace espalier
