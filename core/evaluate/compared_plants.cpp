#include "core/evaluate/compared_plants.h"

#include "core/evaluate/match/barcode.h"
#include "core/evaluate/match/comparable.h"
#include "core/evaluate/match/segments.h"
#include "core/evaluate/plant_measures.h"
#include "core/skeleton/axes.h"

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

/// What `make` gives, made once.
template <class Value, class Make> const Value& once(std::optional<Value>& kept, const Make& make) {
  if (!kept) kept.emplace(make());
  return *kept;
}

template <class Part> const Part* partAt(const std::vector<Part>& parts, double distance) {
  const auto found = std::ranges::find(parts, distance, &Part::distance);
  return found == parts.end() ? nullptr : &*found;
}

std::size_t partCount(const Skeleton& skeleton, EditUnit unit) {
  if (unit == EditUnit::node) return skeleton.size();
  if (unit == EditUnit::segment) return unbranchedSegments(skeleton).size();
  return axes(skeleton).size();
}

} // namespace

EditedParts editedParts(const ComparedPlants& plants, EditUnit unit) {
  return {partCount(plants.result(), unit), partCount(plants.reference(), unit)};
}

ScoreOptions resolved(const ScoreOptions& options, const Skeleton& reference) {
  ScoreOptions result = options;
  if (result.distance <= 0) result.distance = usualTolerance(reference);
  if (result.landmarkDistance <= 0) result.landmarkDistance = medianEdgeLength(reference);
  return result;
}

std::map<std::string, double> studyScores(const Skeleton& result, const Skeleton& reference,
                                          const ScoreOptions& options, const Progress& progress) {
  const auto [distance, landmarkDistance] = resolved(options, reference);
  ComparedPlants plants(result, reference,
                        {.tolerance = {.distances = {distance}},
                         .placeDistance = distance,
                         .landmarkDistance = landmarkDistance},
                        progress);
  std::map<std::string, double> values;
  for (const Score* score : scoresIn(inStudies))
    values[score->key] = score->compute(plants).value_or(0);
  return values;
}

ComparedPlants::ComparedPlants(const Skeleton& result, const Skeleton& reference,
                               const ComparisonOptions& options, const Progress& progress)
    : result_(result), reference_(reference), options_(options), progress_(progress),
      distance_(resolved({options.placeDistance, options.landmarkDistance}, reference).distance),
      landmarkDistance_(
          resolved({options.placeDistance, options.landmarkDistance}, reference).landmarkDistance),
      step_(options.tolerance.step > 0 ? options.tolerance.step
                                       : defaultTolerances(reference).front()) {}

ComparedPlants& ComparedPlants::with(const Progress& progress) {
  progress_ = progress;
  return *this;
}

const std::optional<Registration>& ComparedPlants::registration() const {
  return options_.laidBefore;
}

const AuthorsComparison& ComparedPlants::authors() {
  return once(authors_,
              [&] { return authorsComparison(result_, reference_, options_.authors, progress_); });
}

const PathMatches& ComparedPlants::paths() {
  return once(paths_, [&] { return pathMatches(authors(), progress_); });
}

const ToleranceCurve& ComparedPlants::tolerance() {
  return once(tolerance_,
              [&] { return toleranceCurve(result_, reference_, options_.tolerance, progress_); });
}

const ToleranceScore* ComparedPlants::near() {
  return partAt(tolerance().scores, distance_);
}

const std::vector<CappedScore>& ComparedPlants::allCapped() {
  return once(capped_, [&] {
    CappedOptions options{.distances = {}, .step = step_};
    for (const ToleranceScore& score : tolerance().scores) // no pair is capped at no distance
      if (score.distance > 0) options.distances.push_back(score.distance);
    return cappedScores(result_, reference_, options, progress_);
  });
}

const CappedScore* ComparedPlants::capped() {
  return partAt(allCapped(), distance_);
}

const std::optional<EditComparison>& ComparedPlants::edit() {
  return once(edit_, [&]() -> std::optional<EditComparison> {
    const auto [ofResult, ofReference] = editedParts(*this, options_.edit.unit);
    if (ofResult * ofReference > mostEditedPairs) return std::nullopt;
    return editComparison(result_, reference_, options_.edit, progress_);
  });
}

const LandmarkAgreement& ComparedPlants::tips() {
  return once(tips_, [&] {
    return landmarkAgreement(espalier::tips(result_), espalier::tips(reference_),
                             landmarkDistance_);
  });
}

const LandmarkAgreement& ComparedPlants::branchings() {
  return once(branchings_, [&] {
    return landmarkAgreement(espalier::branchings(result_), espalier::branchings(reference_),
                             landmarkDistance_);
  });
}

const DiademScore& ComparedPlants::diadem() {
  return once(diadem_,
              [&] { return diademScore(result_, reference_, {.distance = landmarkDistance_}); });
}

const PathLengthAgreement& ComparedPlants::pathLengths() {
  return once(pathLengths_, [&] {
    return pathLengthAgreement(result_, reference_, {.distance = landmarkDistance_, .step = step_},
                               progress_);
  });
}

const NetworkAgreement& ComparedPlants::network() {
  return once(network_, [&] {
    return networkAgreement(result_, reference_,
                            {.deviation = distance_, .distance = landmarkDistance_, .step = step_},
                            progress_);
  });
}

double ComparedPlants::barcodeDistance() {
  return once(barcodeDistance_,
              [&] { return espalier::barcodeDistance(barcode(result_), barcode(reference_)); });
}

const RadiusAgreement& ComparedPlants::radii() {
  return once(radii_, [&] {
    const auto& coverages = options_.coverages;
    return radiusAgreement(result_, reference_, landmarkDistance_, step_,
                           coverages ? *coverages : std::vector<double>(), progress_);
  });
}

const StemDiameters& ComparedPlants::stems() {
  return once(stems_, [&] {
    const UpAxis up = options_.registration.up;
    return stemDiameters(standing(result_, up), standing(reference_, up), options_.breastHeight);
  });
}

const ArchitectureAgreement& ComparedPlants::architecture() {
  return once(architecture_, [&] {
    return architectureAgreement(result_, reference_, authors(), landmarkDistance_, step_,
                                 progress_);
  });
}

const Differences& ComparedPlants::differences() {
  if (options_.differences != nullptr) return *options_.differences;
  return once(differences_,
              [&] { return espalier::differences(result_, reference_, distance_, progress_); });
}

void ComparedPlants::moveTo(Comparison& comparison) && {
  comparison.network = network();
  comparison.tips = tips();
  comparison.branchings = branchings();
  comparison.diadem = diadem();
  comparison.pathLengths = pathLengths();
  comparison.barcodeDistance = barcodeDistance();
  comparison.differences = differences();
  static_cast<void>(paths()); // these read parts that are moved
  static_cast<void>(architecture());
  static_cast<void>(allCapped());
  static_cast<void>(edit());
  static_cast<void>(radii());
  static_cast<void>(stems());
  comparison.paths = std::move(*paths_);
  comparison.architecture = std::move(*architecture_);
  comparison.capped = std::move(*capped_);
  comparison.edit = std::move(*edit_);
  comparison.radii = std::move(*radii_);
  comparison.stems = std::move(*stems_);
  comparison.tolerance = std::move(*tolerance_);
  comparison.authors = std::move(*authors_);
}

} // namespace espalier
