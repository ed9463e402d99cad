#include "core/evaluate/registration.h"

#include "core/base/parallel.h"
#include "core/evaluate/comparable.h"
#include "core/evaluate/edge_index.h"
#include "core/evaluate/even_samples.h"
#include "core/evaluate/segments.h"
#include "core/evaluate/shift_votes.h"
#include "core/skeleton/bounds.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace espalier {
namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// One of the two skeletons, to be sampled or to be searched.
struct Side {
  EdgeIndex index;
  std::vector<EvenSample> samples;

  Side(const Skeleton& skeleton, std::size_t samplesWanted)
      : index(skeleton),
        samples(evenSamples(skeleton, totalLength(skeleton) / static_cast<double>(samplesWanted))) {
  }
};

/// A place of the result under the motion so far, and the place of the reference it belongs to.
struct Pair {
  Eigen::Vector3d moving, target; // [L]
  Eigen::Vector3d along;          // direction of the edge found; zero where the pair pulls fully
  double distance;                // [L]
};

std::vector<Pair> pairsUnder(const Eigen::Isometry3d& motion, const Side& result,
                             const Side& reference, const Progress& progress) {
  const Eigen::Isometry3d back = motion.inverse();
  const std::size_t there = result.samples.size();
  std::vector<Pair> pairs(there + reference.samples.size());
  parallelFor(static_cast<Eigen::Index>(pairs.size()), [&](Eigen::Index i) {
    const auto k = static_cast<std::size_t>(i);
    if (k < there) {
      const Eigen::Vector3d place = motion * result.samples[k].position;
      const NearestPlace found = *reference.index.nearest(place);
      pairs[k] = {place, found.position, found.along, found.distance};
    } else {
      const Eigen::Vector3d place = reference.samples[k - there].position;
      const NearestPlace found = *result.index.nearest(back * place);
      pairs[k] = {motion * found.position, place, motion.linear() * found.along, found.distance};
    }
  });
  progress.check();
  return pairs;
}

/// Mean distance, each up to `reach`, both directions counting alike.
double residual(const std::vector<Pair>& pairs, std::size_t there, double reach) {
  double sums[2] = {0, 0};
  for (std::size_t i = 0; i < pairs.size(); ++i)
    sums[i < there ? 0 : 1] += std::min(pairs[i].distance, reach);
  return (sums[0] / static_cast<double>(there) +
          sums[1] / static_cast<double>(pairs.size() - there)) /
         2;
}

/// How near a pair has to be to pull: as near as most pairs are, but not beyond `reach`. The floor
/// lets skeletons that fit to the last digit keep pulling.
double fadingDistance(std::vector<Pair> pairs, double reach) {
  const auto middle = pairs.begin() + static_cast<std::ptrdiff_t>(pairs.size() / 2);
  std::nth_element(pairs.begin(), middle, pairs.end(),
                   [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
  return std::clamp(2 * middle->distance, reach / 50, reach);
}

/// The small motion about `center` that brings the pairs together: one Gauss-Newton step.
Eigen::Isometry3d stepOf(const std::vector<Pair>& pairs, const Eigen::Vector3d& center, double size,
                         double fading, bool rotates) {
  Matrix6d normal = Matrix6d::Zero();
  Vector6d right = Vector6d::Zero();
  for (const Pair& pair : pairs) {
    const double root = 1 / (1 + pair.distance * pair.distance / (fading * fading));
    const double weight = root * root;
    // Sliding along an edge is free, but for a little that keeps the step definite.
    const Eigen::Matrix3d across =
        weight * (Eigen::Matrix3d::Identity() - 0.999 * pair.along * pair.along.transpose());
    const Eigen::Vector3d arm = (pair.moving - center) / size; // turns in units of the shifts
    Eigen::Matrix<double, 3, 6> jacobian;
    jacobian << Eigen::Matrix3d::Identity(),
        (Eigen::Matrix3d() << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0)
            .finished();
    normal += jacobian.transpose() * across * jacobian;
    right += jacobian.transpose() * (across * (pair.target - pair.moving));
  }
  Vector6d step = Vector6d::Zero();
  if (rotates) {
    normal.diagonal().array() += 1e-9 * normal.trace();
    step = normal.ldlt().solve(right);
  } else {
    step.head<3>() = normal.topLeftCorner<3, 3>().ldlt().solve(right.head<3>());
  }
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  const double angle = step.tail<3>().norm() / size;
  if (angle > 0) motion.rotate(Eigen::AngleAxisd(angle, step.tail<3>().normalized()));
  motion.translation() = center + step.head<3>() - motion.linear() * center;
  return motion;
}

struct Fit {
  Eigen::Isometry3d motion;
  double residual; // [L]
};

struct Frame {
  Eigen::Vector3d center; // of the reference: what turns go about [L]
  double size;            // of the reference [L]
  double reach;           // [L]
  bool rotates;
};

/// The best motion met while stepping from `start`.
Fit refined(const Eigen::Isometry3d& start, const Side& result, const Side& reference,
            const Frame& frame, int steps, const Progress& progress) {
  Eigen::Isometry3d motion = start;
  Fit best{start, std::numeric_limits<double>::infinity()};
  for (int i = 0; i <= steps; ++i) {
    const std::vector<Pair> pairs = pairsUnder(motion, result, reference, progress);
    const double distance = residual(pairs, result.samples.size(), frame.reach);
    if (distance < best.residual) best = {motion, distance};
    if (distance == 0) break;
    const double fading = fadingDistance(pairs, frame.reach);
    const Eigen::Isometry3d step = stepOf(pairs, frame.center, frame.size, fading, frame.rotates);
    motion = step * motion;
    const double moves = (step * frame.center - frame.center).norm() +
                         (step.linear() - Eigen::Matrix3d::Identity()).norm() * frame.size;
    if (moves < 1e-9 * frame.size) break;
  }
  return best;
}

Eigen::Vector3d centroid(const std::vector<EvenSample>& samples) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const EvenSample& sample : samples)
    sum += sample.position;
  return sum / static_cast<double>(samples.size());
}

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

/// The best motion by few samples, over all starts.
Eigen::Isometry3d roughMotion(const Skeleton& result, const Skeleton& reference, const Frame& frame,
                              double radius, const Progress& progress) {
  const Side roughResult(result, 1000);
  const Side roughReference(reference, 1000);
  const auto starts = startingShifts(
      result, reference, centroid(roughReference.samples) - centroid(roughResult.samples), radius,
      frame.reach / 2);
  Fit best{Eigen::Isometry3d::Identity(), 0};
  for (std::size_t i = 0; i < starts.size(); ++i) {
    const Eigen::Isometry3d start{Eigen::Translation3d(starts[i])};
    const Fit fit = refined(start, roughResult, roughReference, frame, 15, progress);
    if (i == 0 || fit.residual < 0.95 * best.residual) best = fit;
    progress.update(static_cast<double>(i + 1) / static_cast<double>(starts.size()));
  }
  return best.motion;
}

} // namespace

Registration registration(const Skeleton& result, const Skeleton& reference,
                          const RegistrationOptions& options, const Progress& progress) {
  requireComparable(result, "the plant");
  requireComparable(reference, "the reference");
  const Eigen::AlignedBox3d box = bounds(reference);
  // Half the mean segment: twigs further apart are other twigs. Edges would depend on the nodes.
  const auto segments = static_cast<double>(unbranchedSegments(reference).size());
  const Frame frame{.center = box.center(),
                    .size = box.diagonal().norm(),
                    .reach = totalLength(reference) / segments / 2,
                    .rotates = options.rotates};
  const double radius = options.searchRadius > 0 ? options.searchRadius : frame.size / 10;
  const Eigen::Isometry3d start =
      options.motion ? *options.motion
                     : roughMotion(result, reference, frame, radius, progress.part(0, 0.5));
  const Side fineResult(result, 4000);
  const Side fineReference(reference, 4000);
  const Fit before =
      refined(Eigen::Isometry3d::Identity(), fineResult, fineReference, frame, 0, progress);
  Fit after = refined(start, fineResult, fineReference, frame, options.motion ? 0 : 40, progress);
  if (!options.motion && after.residual >= before.residual) after = before;
  progress.update(1);
  const Eigen::Vector3d middle = bounds(result).center();
  return {.motion = after.motion,
          .shift = after.motion * middle - middle,
          .isGiven = options.motion.has_value(),
          .reach = frame.reach,
          .residualBefore = before.residual,
          .residualAfter = after.residual};
}

Skeleton moved(Skeleton skeleton, const Eigen::Isometry3d& motion) {
  for (const NodeId id : skeleton.ids())
    skeleton.setPosition(id, motion * skeleton[id].position);
  return skeleton;
}

} // namespace espalier
