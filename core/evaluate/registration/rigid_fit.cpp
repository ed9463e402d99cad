#include "core/evaluate/registration/rigid_fit.h"

#include "core/base/motion_step.h"
#include "core/base/parallel.h"
#include "core/evaluate/match/comparable.h"
#include "core/evaluate/match/tolerance_curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace espalier {
namespace {

/// A place of the result under the motion so far, and the place of the reference it belongs to.
struct Match {
  Eigen::Vector3d moving, target; // [L]
  Eigen::Vector3d along;          // direction of the edge found; zero where the match pulls fully
  double distance;                // [L]
};

std::vector<Match> matchesUnder(const Eigen::Isometry3d& motion, const FitPair& pair,
                                const Progress& progress) {
  const Eigen::Isometry3d back = motion.inverse();
  const std::size_t there = pair.result.samples.size();
  std::vector<Match> matches(there + pair.reference.samples.size());
  parallelFor(static_cast<Eigen::Index>(matches.size()), [&](Eigen::Index i) {
    const auto k = static_cast<std::size_t>(i);
    if (k < there) {
      const Eigen::Vector3d place = motion * pair.result.samples[k].position;
      const NearestPlace found = *pair.reference.index.nearest(place);
      matches[k] = {place, found.position, found.along, found.distance};
    } else {
      const Eigen::Vector3d place = pair.reference.samples[k - there].position;
      const NearestPlace found = *pair.result.index.nearest(back * place);
      matches[k] = {motion * found.position, place, motion.linear() * found.along, found.distance};
    }
  });
  progress.check();
  return matches;
}

/// How well a motion fits: both directions count alike.
RigidFit fitOf(const Eigen::Isometry3d& motion, const std::vector<Match>& matches,
               const FitPair& pair) {
  const std::size_t there = pair.result.samples.size();
  double sums[2] = {0, 0};
  double near[2] = {0, 0};
  for (std::size_t i = 0; i < matches.size(); ++i) {
    sums[i < there ? 0 : 1] += std::min(matches[i].distance, pair.reach);
    near[i < there ? 0 : 1] += matches[i].distance < pair.reach / 4 ? 1 : 0;
  }
  const auto ofResult = static_cast<double>(there);
  const auto ofReference = static_cast<double>(matches.size() - there);
  return {.motion = motion,
          .residual = (sums[0] / ofResult + sums[1] / ofReference) / 2,
          .near = harmonicMean(near[0] / ofResult, near[1] / ofReference)};
}

/// How near a match has to be to pull: as near as most are, but not beyond `reach`. The floor lets
/// skeletons that fit to the last digit keep pulling.
double fadingDistance(std::vector<Match> matches, double reach) {
  const auto middle = matches.begin() + static_cast<std::ptrdiff_t>(matches.size() / 2);
  std::nth_element(matches.begin(), middle, matches.end(),
                   [](const Match& a, const Match& b) { return a.distance < b.distance; });
  return std::clamp(2 * middle->distance, reach / 50, reach);
}

/// The small motion about the center that brings the matches together.
MotionStep stepOf(const std::vector<Match>& matches, const FitPair& pair, double fading) {
  MotionStep step(pair.center, pair.size);
  for (const Match& match : matches) {
    const double root = 1 / (1 + match.distance * match.distance / (fading * fading));
    const double weight = root * root;
    // Sliding along an edge is free, but for a little that keeps the step definite.
    step.add(match.moving, match.target,
             weight *
                 (Eigen::Matrix3d::Identity() - 0.999 * match.along * match.along.transpose()));
  }
  return step;
}

} // namespace

std::vector<EvenSample> samplesOf(const Skeleton& skeleton, std::size_t samples) {
  return evenSamples(skeleton, totalLength(skeleton) / static_cast<double>(samples));
}

RigidFit fitAt(const Eigen::Isometry3d& motion, const FitPair& pair, const Progress& progress) {
  return fitOf(motion, matchesUnder(motion, pair, progress), pair);
}

RigidFit refined(const Eigen::Isometry3d& start, const FitPair& pair, const FitSteps& steps,
                 const Progress& progress) {
  Eigen::Isometry3d motion = start;
  RigidFit best{.motion = start, .residual = std::numeric_limits<double>::infinity()};
  double width = steps.width;
  for (int i = 0; i <= steps.most; ++i) {
    const std::vector<Match> matches = matchesUnder(motion, pair, progress);
    const RigidFit fit = fitOf(motion, matches, pair);
    if (fit.residual < best.residual) best = fit;
    if (fit.residual == 0) break;
    const double fading = std::max(width, fadingDistance(matches, pair.reach));
    const MotionStep step = stepOf(matches, pair, fading);
    const Eigen::Isometry3d next = step.motion(steps.turns);
    motion = next * motion;
    if (width <= pair.reach && step.lengthOf(next) < 1e-9 * pair.size) break;
    width *= 0.7;
  }
  return best;
}

} // namespace espalier
