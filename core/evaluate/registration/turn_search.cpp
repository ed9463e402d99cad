#include "core/evaluate/registration/turn_search.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace espalier {
namespace {

constexpr double inRadians = std::numbers::pi / 180;

/// Every so many of the samples, so that about `wanted` are left.
std::vector<EvenSample> thinned(const std::vector<EvenSample>& samples, std::size_t wanted) {
  const std::size_t count = std::min(wanted, samples.size());
  std::vector<EvenSample> kept;
  kept.reserve(count);
  for (std::size_t k = 0; k < count; ++k)
    kept.push_back(samples[(2 * k + 1) * samples.size() / (2 * count)]);
  return kept;
}

/// The same pair with fewer samples and another reach.
FitPair coarse(const FitPair& pair, std::size_t samples, double reach) {
  return {{pair.result.index, thinned(pair.result.samples, samples)},
          {pair.reference.index, thinned(pair.reference.samples, samples)},
          pair.center,
          pair.size,
          reach};
}

/// The angle between two turns about `up` that are tried: half of the length moves by two reaches
/// at most from one to the next. Pairs pull from far at first, so that is fine enough.
double angleStep(const FitPair& pair, const Eigen::Vector3d& up) {
  const Eigen::Vector3d middle = centroid(pair.reference.samples);
  std::vector<double> distances; // from an upright axis
  for (const EvenSample& sample : pair.reference.samples)
    distances.push_back((sample.position - middle).cross(up).norm());
  const auto median = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), median, distances.end());
  return std::clamp(2 * pair.reach / std::max(*median, pair.reach), 3 * inRadians, 15 * inRadians);
}

/// A place of the result and one of the reference that may be the same.
struct Anchor {
  Eigen::Vector3d from, to; // [L]
};

/// All angles about `up` for each anchor.
std::vector<Eigen::Isometry3d> startsOf(const std::vector<Anchor>& anchors,
                                        const Eigen::Vector3d& up, double step) {
  const auto angles = static_cast<int>(std::ceil(2 * std::numbers::pi / step));
  std::vector<Eigen::Isometry3d> starts;
  for (int k = 0; k < angles; ++k)
    for (const Anchor& anchor : anchors) {
      Eigen::Isometry3d start(Eigen::AngleAxisd(2 * std::numbers::pi * k / angles, up));
      start.translation() = anchor.to - start.linear() * anchor.from;
      starts.push_back(start);
    }
  return starts;
}

/// Each start refined, the best first.
std::vector<RigidFit> refinedEach(const std::vector<Eigen::Isometry3d>& starts, const FitPair& pair,
                                  const FitSteps& steps, const Progress& progress) {
  std::vector<RigidFit> fits(starts.size());
  parallelFor(
      static_cast<Eigen::Index>(starts.size()),
      [&](Eigen::Index i) {
        const auto k = static_cast<std::size_t>(i);
        fits[k] = refined(starts[k], pair, steps, progress.part(0, 0));
      },
      progress, 1);
  std::ranges::stable_sort(fits, {}, &RigidFit::residual);
  return fits;
}

/// How far apart two motions lay the plant, about [L].
double apart(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, const FitPair& pair) {
  const Eigen::Isometry3d between = a * b.inverse();
  return (between * pair.center - pair.center).norm() +
         Eigen::AngleAxisd(between.linear()).angle() * pair.size / 2;
}

/// The first so many that do not lay the plant where one before them does.
std::vector<Eigen::Isometry3d> firstOf(const std::vector<RigidFit>& fits, std::size_t wanted,
                                       const FitPair& pair) {
  std::vector<Eigen::Isometry3d> kept;
  for (const RigidFit& fit : fits) {
    if (kept.size() == wanted) break;
    const bool isNew = std::ranges::none_of(kept, [&](const Eigen::Isometry3d& motion) {
      return apart(fit.motion, motion, pair) < pair.reach;
    });
    if (isNew) kept.push_back(fit.motion);
  }
  return kept;
}

double angleOf(const RigidFit& fit) {
  return Eigen::AngleAxisd(fit.motion.linear()).angle();
}

} // namespace

bool isClearlyBetter(const RigidFit& fit, const RigidFit& than, double reach) {
  return fit.residual <= than.residual - std::max(0.1 * than.residual, 0.01 * reach);
}

RigidFit turnedFit(const Skeleton& result, const Skeleton& reference, const FitPair& pair,
                   UpAxis up, const Progress& progress) {
  const Eigen::Vector3d axis = Eigen::Vector3d::Unit(static_cast<int>(up));
  const FitPair few = coarse(pair, 150, 2 * pair.reach);
  const std::vector<Anchor> anchors = {
      {centroid(pair.result.samples), centroid(pair.reference.samples)},
      {result[result.roots().front()].position, reference[reference.roots().front()].position}};
  std::vector<RigidFit> fits =
      refinedEach(startsOf(anchors, axis, angleStep(pair, axis)), few,
                  {.most = 8, .turns = true, .width = pair.size / 10}, progress.part(0, 0.6));
  const FitPair more = coarse(pair, 400, pair.reach);
  fits = refinedEach(firstOf(fits, 12, pair), more, {.most = 10, .turns = true},
                     progress.part(0.6, 0.8));
  fits =
      refinedEach(firstOf(fits, 4, pair), pair, {.most = 20, .turns = true}, progress.part(0.8, 1));
  std::ranges::stable_sort(fits, {}, angleOf);
  RigidFit best = fits.front();
  for (const RigidFit& fit : fits)
    if (isClearlyBetter(fit, best, pair.reach)) best = fit;
  return best;
}

} // namespace espalier
