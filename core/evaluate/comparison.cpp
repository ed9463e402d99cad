#include "core/evaluate/comparison.h"

#include "core/base/shown.h"
#include "core/evaluate/compared_plants.h"
#include "core/evaluate/comparison_warnings.h"
#include "core/evaluate/match/comparable.h"
#include "core/evaluate/plant_measures.h"

#include <algorithm>
#include <numbers>

namespace espalier {
namespace {

void warn(Comparison& comparison, const std::optional<ShownMessage>& warning) {
  if (warning) comparison.warnings.push_back(*warning);
}

std::string inBrackets(const Eigen::Vector3d& vector) {
  return '(' + inDigits(vector.x(), 4) + ", " + inDigits(vector.y(), 4) + ", " +
         inDigits(vector.z(), 4) + ')';
}

void warnOfShift(Comparison& comparison, double unit) {
  if (!comparison.registration) return;
  const Registration& lay = *comparison.registration;
  if (lay.angle() == 0 && lay.shift.norm() <= unit) return;
  const std::string far = inDigits(lay.shift.norm(), 4);
  const Eigen::Vector3d axis = ((1e3 * lay.axis()).array().round() / 1e3 + 0.0).matrix();
  comparison.shiftWarning =
      lay.angle() > 0
          ? ShownMessage{Shown::tr("the plant lay %1 off the reference: it was turned by %2 "
                                   "degrees about %3 and moved by %4 to lie on it"),
                         {far, inDigits(lay.angle() * 180 / std::numbers::pi, 4), inBrackets(axis),
                          inBrackets(lay.shift)}}
          : ShownMessage{
                Shown::tr("the plant lay %1 off the reference: it was moved by %2 to lie on it"),
                {far, inBrackets(lay.shift)}};
  comparison.warnings.push_back(comparison.shiftWarning);
}

/// Little lies near once the plant is laid on the reference, or nothing does.
void warnOfMisfit(Comparison& comparison, const ToleranceCurve& curve) {
  const auto& lay = comparison.registration;
  const std::optional<ShownMessage> ofFit = lay ? warningOfFit(*lay) : std::nullopt;
  warn(comparison, ofFit ? ofFit : warningOfDistance(curve, lay.has_value()));
}

/// Light on the surface of a plant; none, with a warning, of one without radii.
std::optional<LightInterception> lightOf(Comparison& comparison, const Skeleton& skeleton,
                                         ComparedAs as, const LightOptions& options,
                                         const Progress& progress) {
  std::optional<LightInterception> light = lightOn(skeleton, options, progress);
  if (!light) warn(comparison, warningOfNoRadii(as));
  return light;
}

void warnOfEdits(Comparison& comparison, ComparedPlants& plants, EditUnit unit) {
  if (plants.edit()) return;
  const auto [ofResult, ofReference] = editedParts(plants, unit);
  comparison.warnings.push_back(
      {Shown::tr("the edit distance of %1 and %2 parts would take too long and is left out: "
                 "compare segments or axes"),
       {std::to_string(ofResult), std::to_string(ofReference)}});
}

/// pre: both stand along z
void measureEach(Comparison& comparison, const Skeleton& result, const Skeleton& reference) {
  comparison.resultTraits = traits(result);
  comparison.referenceTraits = traits(reference);
  comparison.radiusLimits = radiusLimits(reference);
  comparison.resultWood = woodAmounts(result, comparison.radiusLimits);
  comparison.referenceWood = woodAmounts(reference, comparison.radiusLimits);
}

/// All scores where they lie, and those that take a distance at each of the curve's.
void score(Comparison& comparison, ComparedPlants& plants, const Progress& progress) {
  const double near = plants.distance();
  const auto share = 1 / static_cast<double>(scores().size());
  double done = 0;
  for (const Score& each : scores()) {
    plants.with(progress.part(done, done + share));
    comparison.scores[each.key] = each.compute(plants);
    done += share;
  }
  for (const ToleranceScore& at : plants.tolerance().scores) {
    plants.goTo(at.distance);
    comparison.scoresAt.push_back({at.distance, valuesOf(scoresByDistance(), plants)});
  }
  plants.goTo(near);
}

/// How much of the way around each node of the reference the scanner saw; null without a scan.
std::shared_ptr<const std::vector<double>>
coveragesOf(const Comparison& comparison, const Skeleton& result, const Skeleton& reference,
            const ComparisonOptions& options, const Progress& progress) {
  if (options.coverages || !options.scan) return options.coverages;
  const Eigen::Isometry3d motion = comparison.registration
                                       ? toScan(*options.scan.cloud, result, reference,
                                                comparison.registration->motion, progress)
                                       : Eigen::Isometry3d::Identity();
  return std::make_shared<const std::vector<double>>(
      seenArcs(moved(reference, motion), options.scan, progress));
}

} // namespace

Comparison compare(const Skeleton& result, const Skeleton& reference,
                   const ComparisonOptions& options, const Progress& progress) {
  requireComparable(result, ComparedAs::plant);
  requireComparable(reference, ComparedAs::reference);
  Comparison comparison;
  const UpAxis up = options.registration.up;
  const Skeleton uprightReference = standing(reference, up);
  measureEach(comparison, standing(result, up), uprightReference);
  warn(comparison, warningOfTrees(comparison.resultTraits, ComparedAs::plant));
  warn(comparison, warningOfTrees(comparison.referenceTraits, ComparedAs::reference));
  const std::optional<ShownMessage> ofSize =
      warningOfSize(comparison.resultTraits, comparison.referenceTraits);
  warn(comparison, ofSize);

  Skeleton laid = result;
  if (options.registers) {
    comparison.registration = registration(result, reference, options.registration,
                                           progress.part(0, 0.6, Shown::tr("Registering")));
    laid = moved(result, comparison.registration->motion);
    warnOfShift(comparison, defaultTolerances(reference).front());
  }
  comparison.coverages =
      coveragesOf(comparison, result, reference, options, progress.part(0.6, 0.61));
  ComparisonOptions laidOptions = options;
  laidOptions.coverages = comparison.coverages;
  if (!laidOptions.laidBefore) laidOptions.laidBefore = comparison.registration;
  ComparedPlants plants(laid, reference, laidOptions, progress.part(0.61, 0.63));
  static_cast<void>(plants.authors());
  plants.with(progress.part(0.63, 0.68, Shown::tr("Counting edits")));
  warnOfEdits(comparison, plants, options.edit.unit);
  plants.with(progress.part(0.68, 0.8, Shown::tr("Measuring distances")));
  if (!ofSize) warnOfMisfit(comparison, plants.tolerance());
  score(comparison, plants, progress.part(0.8, 0.95));
  const double near = plants.distance();
  std::move(plants).moveTo(comparison);
  const Skeleton uprightLaid = standing(laid, up);
  comparison.byPlace =
      agreementByPlace(uprightLaid, uprightReference, near, comparison.tolerance.step,
                       progress.part(0.95, options.light ? 0.96 : 1));
  if (options.light) {
    comparison.resultLight = lightOf(comparison, uprightLaid, ComparedAs::plant, *options.light,
                                     progress.part(0.96, 0.98, Shown::tr("Measuring light")));
    comparison.referenceLight = lightOf(comparison, uprightReference, ComparedAs::reference,
                                        *options.light, progress.part(0.98, 1));
  }
  progress.update(1);
  return comparison;
}

} // namespace espalier
