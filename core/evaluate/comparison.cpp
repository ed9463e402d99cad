#include "core/evaluate/comparison.h"

#include "core/evaluate/comparable.h"

#include <sstream>

namespace espalier {
namespace {

void warnOfSize(Comparison& comparison) {
  const double ratio =
      comparison.resultTraits.extent.norm() / comparison.referenceTraits.extent.norm();
  if (ratio <= 20 && ratio >= 1.0 / 20) return;
  std::ostringstream text;
  text.precision(3);
  text << "the result is " << (ratio > 1 ? ratio : 1 / ratio) << " times as "
       << (ratio > 1 ? "large" : "small")
       << " as the reference: check that both are in the same unit and of the same plant";
  comparison.warnings.push_back(text.str());
}

void warnOfShift(Comparison& comparison, double unit) {
  if (!comparison.registration || comparison.registration->shift.norm() <= unit) return;
  const Eigen::Vector3d& shift = comparison.registration->shift;
  std::ostringstream text;
  text.precision(4);
  text << "the result lay " << shift.norm() << " off the reference: it was shifted by ("
       << shift.x() << ", " << shift.y() << ", " << shift.z() << ") before it was measured";
  comparison.shiftWarning = text.str();
  comparison.warnings.push_back(comparison.shiftWarning);
}

} // namespace

Comparison compare(const Skeleton& result, const Skeleton& reference,
                   const ComparisonOptions& options, const Progress& progress) {
  requireComparable(result, "the result");
  requireComparable(reference, "the reference");
  Comparison comparison;
  comparison.resultTraits = traits(result);
  comparison.referenceTraits = traits(reference);
  warnOfSize(comparison);

  Skeleton laid = result;
  if (options.registers) {
    comparison.registration =
        registration(result, reference, options.registration, progress.part(0, 0.6, "Registering"));
    laid = moved(result, comparison.registration->motion);
    warnOfShift(comparison, defaultTolerances(reference).front());
  }
  comparison.authors = authorsComparison(laid, reference, options.authors, progress.part(0.6, 0.7));
  comparison.tolerance = toleranceCurve(laid, reference, options.tolerance,
                                        progress.part(0.7, 0.95, "Measuring distances"));

  const double distance = options.landmarkDistance > 0 ? options.landmarkDistance
                                                       : comparison.referenceTraits.medianEdge;
  comparison.tips = landmarkAgreement(tips(laid), tips(reference), distance);
  comparison.branchings = landmarkAgreement(branchings(laid), branchings(reference), distance);
  progress.update(1);
  return comparison;
}

} // namespace espalier
