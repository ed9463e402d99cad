#include "core/evaluate/evaluation.h"

#include "core/base/shown.h"
#include "core/evaluate/match/comparable.h"
#include "core/skeleton/bounds.h"

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

constexpr int curveSteps = 40;

/// On the scan lies whichever of the two is nearer to it.
std::vector<double> coveragesOf(const Skeleton& result, const Skeleton& reference,
                                const Eigen::Isometry3d& motion, const EvaluatedScan& scan,
                                const Progress& progress) {
  const Eigen::Isometry3d place =
      toScan(*scan.cloud, result, reference, motion.inverse(), progress);
  return seenArcs(moved(reference, place), scan, progress);
}

} // namespace

std::vector<double> curveDistances(double tolerance, double coarsest) {
  const double most = std::max(coarsest, 2 * tolerance);
  std::vector<double> distances;
  for (int i = 0; i <= curveSteps; ++i)
    distances.push_back(most * i / curveSteps);
  return distances;
}

Eigen::Isometry3d referenceMotion(const Skeleton& result, const Skeleton& reference,
                                  const EvaluationOptions& options, const Progress& progress) {
  if (!options.registers) return Eigen::Isometry3d::Identity();
  if (options.motion && !options.isResultEdited) return *options.motion;
  RegistrationOptions how{.turns = options.turns, .up = options.up};
  if (!options.motion) return registration(result, reference, how, progress).motion.inverse();
  how.goodEnough = 0.5; // an edit does not turn it to another side, unless it fits nowhere
  const Eigen::Isometry3d again =
      registration(result, moved(reference, *options.motion), how, progress).motion.inverse();
  const Eigen::Isometry3d found = again * *options.motion;
  const Eigen::AlignedBox3d box = bounds(reference);
  const auto apart = [&](const Eigen::Vector3d& place) {
    return (found * place - *options.motion * place).norm();
  };
  const double limit = defaultTolerances(reference).front() / 2;
  return std::max(apart(box.min()), apart(box.max())) > limit ? found : *options.motion;
}

Evaluation evaluate(const Skeleton& result, const Skeleton& reference,
                    const EvaluationOptions& options, const Progress& progress) {
  requireComparable(result, ComparedAs::plant);
  requireComparable(reference, ComparedAs::reference);
  const std::vector<double> usual = defaultTolerances(reference);
  Evaluation made;
  made.motion =
      referenceMotion(result, reference, options, progress.part(0, 0.5, Shown::tr("Registering")));
  made.reference = moved(reference, made.motion);
  const Eigen::Vector3d middle = bounds(reference).center();
  made.shift = made.motion * middle - middle;
  made.isShiftLarge = made.shift.norm() > usual.front();
  if (options.registers)
    made.registration = registration(result, reference, {.motion = made.motion.inverse()});
  made.tolerance = options.tolerance > 0 ? options.tolerance : usualTolerance(reference);
  made.differences = differences(result, made.reference, made.tolerance,
                                 progress.part(0.5, 0.65, Shown::tr("Finding differences")));
  ComparisonOptions compared;
  compared.registers = options.registers; // it lies there: only how well it fits is measured
  compared.registration.motion = Eigen::Isometry3d::Identity();
  compared.registration.up = options.up;
  compared.edit = options.edit;
  compared.tolerance.distances = {made.tolerance};
  compared.placeDistance = made.tolerance;
  compared.breastHeight = options.breastHeight;
  compared.differences = &made.differences;
  compared.laidBefore = made.registration;
  if (!options.motion || made.motion.isApprox(*options.motion))
    compared.coverages = options.coverages;
  if (!compared.coverages && options.scan)
    compared.coverages = std::make_shared<const std::vector<double>>(
        coveragesOf(result, reference, made.motion, options.scan, progress.part(0.65, 0.7)));
  made.comparison =
      compare(result, made.reference, compared, progress.part(0.7, 0.95, Shown::tr("Comparing")));
  made.score = made.comparison.tolerance.scores.front();
  made.curve = toleranceCurve(result, made.reference,
                              {.distances = curveDistances(made.tolerance, usual.back())},
                              progress.part(0.95, 1))
                   .scores;
  return made;
}

} // namespace espalier
