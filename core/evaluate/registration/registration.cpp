#include "core/evaluate/registration/registration.h"

#include "core/evaluate/match/comparable.h"
#include "core/evaluate/match/segments.h"
#include "core/evaluate/registration/rigid_fit.h"
#include "core/evaluate/registration/shift_votes.h"
#include "core/evaluate/registration/turn_search.h"
#include "core/skeleton/bounds.h"

#include <algorithm>
#include <vector>

namespace espalier {
namespace {

/// Shifts from which to refine; the first is none.
std::vector<Eigen::Vector3d> startingShifts(const Skeleton& result, const Skeleton& reference,
                                            const Eigen::Vector3d& centroids, double radius,
                                            double width) {
  const std::vector<Eigen::Vector3d> from = landmarks(result);
  const std::vector<Eigen::Vector3d> to = landmarks(reference);
  std::vector<Eigen::Vector3d> starts = {Eigen::Vector3d::Zero()};
  for (const Eigen::Vector3d& about : {Eigen::Vector3d(Eigen::Vector3d::Zero()), centroids}) {
    const auto shift = votedShift(from, to, about, radius, width);
    if (!shift) continue;
    const bool isNew = std::none_of(starts.begin(), starts.end(), [&](const auto& start) {
      return (start - *shift).norm() < width / 10;
    });
    if (isNew) starts.push_back(*shift);
  }
  return starts;
}

/// The best shift by few samples, over all starts.
Eigen::Isometry3d roughShift(const Skeleton& result, const Skeleton& reference, const FitPair& few,
                             double radius, const Progress& progress) {
  const auto starts = startingShifts(result, reference,
                                     centroid(few.reference.samples) - centroid(few.result.samples),
                                     radius, few.reach / 2);
  RigidFit best;
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const Eigen::Isometry3d start{Eigen::Translation3d(starts[i])};
    const RigidFit fit = refined(start, few, {.most = 15}, progress);
    if (i == 0 || fit.residual < 0.95 * best.residual) best = fit;
    progress.update(static_cast<double>(i + 1) / static_cast<double>(starts.size()));
  }
  return best.motion;
}

/// The two as they lie, with few samples for a search and with many for what is reported.
struct Both {
  EdgeIndex resultIndex;
  EdgeIndex referenceIndex;
  FitPair few;
  FitPair many;

  Both(const Skeleton& result, const Skeleton& reference)
      : resultIndex(result), referenceIndex(reference), few(pairOf(result, reference, 1000)),
        many(pairOf(result, reference, 4000)) {}

private:
  [[nodiscard]] FitPair pairOf(const Skeleton& result, const Skeleton& reference,
                               std::size_t samples) const {
    const Eigen::AlignedBox3d box = bounds(reference);
    // Half the mean segment: twigs further apart are other twigs. Edges would depend on the nodes.
    const auto segments = static_cast<double>(unbranchedSegments(reference).size());
    return {.result = {resultIndex, samplesOf(result, samples)},
            .reference = {referenceIndex, samplesOf(reference, samples)},
            .center = box.center(),
            .size = box.diagonal().norm(),
            .reach = totalLength(reference) / segments / 2};
  }
};

/// @param before where they lie
RigidFit bestFit(const Skeleton& result, const Skeleton& reference, const Both& both,
                 const RigidFit& before, const RegistrationOptions& options,
                 const Progress& progress) {
  const double reach = both.many.reach;
  const double radius = options.searchRadius > 0 ? options.searchRadius : both.few.size / 10;
  const Eigen::Isometry3d shift =
      roughShift(result, reference, both.few, radius, progress.part(0, 0.2));
  const RigidFit shifted = refined(shift, both.many, {.most = 40}, progress);
  RigidFit best = shifted.residual < before.residual ? shifted : before;
  progress.update(0.3);
  const double enough = std::max(0.01, options.goodEnough) * reach;
  if (!options.turns || best.residual <= 0.01 * reach) return best; // nothing is left to gain
  const auto take = [&](const Eigen::Isometry3d& start) {
    const RigidFit fit = refined(start, both.many, {.most = 40, .turns = true}, progress);
    if (isClearlyBetter(fit, best, reach)) best = fit;
  };
  take(best.motion);
  progress.update(0.4);
  if (best.residual > enough)
    take(turnedFit(result, reference, both.few, options.up, progress.part(0.4, 0.9)).motion);
  return best;
}

} // namespace

double Registration::angle() const {
  return Eigen::AngleAxisd(motion.linear()).angle();
}

Eigen::Vector3d Registration::axis() const {
  if (motion.linear() == Eigen::Matrix3d::Identity()) return Eigen::Vector3d::Zero();
  return Eigen::AngleAxisd(motion.linear()).axis();
}

Registration registration(const Skeleton& result, const Skeleton& reference,
                          const RegistrationOptions& options, const Progress& progress) {
  requireComparable(result, ComparedAs::plant);
  requireComparable(reference, ComparedAs::reference);
  const Both both(result, reference);
  const RigidFit before = fitAt(Eigen::Isometry3d::Identity(), both.many, progress);
  const RigidFit after = options.motion
                             ? fitAt(*options.motion, both.many, progress)
                             : bestFit(result, reference, both, before, options, progress);
  const Eigen::Vector3d middle = bounds(result).center();
  progress.update(1);
  return {.motion = after.motion,
          .middle = middle,
          .shift = after.motion * middle - middle,
          .isGiven = options.motion.has_value(),
          .reach = both.many.reach,
          .residualBefore = before.residual,
          .residualAfter = after.residual,
          .nearDistance = both.many.reach / 4,
          .near = after.near};
}

Skeleton moved(Skeleton skeleton, const Eigen::Isometry3d& motion) {
  for (const NodeId id : skeleton.ids())
    skeleton.setPosition(id, motion * skeleton[id].position);
  return skeleton;
}

} // namespace espalier
