#include "core/align/cloud_fit.h"

#include "core/align/cloud_pairs.h"
#include "core/base/coordinates.h"
#include "core/base/error.h"
#include "core/base/motion_step.h"
#include "core/base/shown_message.h"
#include "core/cloud/far_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace espalier {
namespace {

using Eigen::Index;
using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double coarsest = 16;       // [spacings] of the cubes
constexpr double nearest = 2;         // [spacings] what lies so near overlaps
constexpr Index mostSamples = 20'000; // of the moved cloud
constexpr int mostSteps = 40;         // per scale
constexpr double leastOverlap = 0.1;
constexpr std::size_t fewestPairs = 10;
constexpr Index fewestPoints = 50; // of a scale that says anything

/// How far the surfaces of a pair have to face alike, as a cosine: where both clouds show enough of
/// the same surfaces, these alone decide in the end. What a twig shows to one station lies off what
/// it shows to another, and no neighbor says by how much.
double agreementOf(const CloudMatching& matching, const Isometry3d& motion, double reach,
                   const Progress& progress) {
  constexpr double alike = 0.5;
  constexpr double enough = 0.1; // of the moved points
  const std::vector<CloudPair> pairs = matching.pairs(motion, reach, alike, progress);
  const auto agree = std::ranges::count_if(
      pairs, [](const CloudPair& pair) { return std::isfinite(pair.squared); });
  return static_cast<double>(agree) > enough * static_cast<double>(pairs.size()) ? alike : 0;
}

/// The pairs that count, nearest first: a share of all that is given, or the one of the least
/// fractional distance, which weighs how far off pairs are against how many there are.
std::vector<CloudPair> trimmed(std::vector<CloudPair> pairs, double overlap) {
  const auto all = static_cast<double>(pairs.size());
  std::erase_if(pairs, [](const CloudPair& pair) { return !std::isfinite(pair.squared); });
  std::ranges::stable_sort(pairs, {}, &CloudPair::squared);
  std::size_t count = pairs.size();
  if (overlap > 0) {
    count = std::min(count, static_cast<std::size_t>(std::ceil(overlap * all)));
  } else {
    constexpr double lambda = 1.3;
    double least = std::numeric_limits<double>::infinity();
    double squares = 0;
    const auto fewest = static_cast<std::size_t>(0.3 * static_cast<double>(pairs.size()));
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      squares += pairs[i].squared;
      const double share = static_cast<double>(i + 1) / all;
      const double fractional =
          std::sqrt(squares / static_cast<double>(i + 1)) / std::pow(share, lambda);
      if (i < fewest || fractional > least) continue;
      least = fractional;
      count = i + 1;
    }
  }
  pairs.resize(count);
  return pairs;
}

/// How far across its surface a pair is apart, squared.
double squaredAcross(const CloudPair& pair) {
  const Vector3d off = pair.target - pair.place;
  return off.dot(pair.across * off);
}

void check(const PointCloud& fixed, const PointCloud& moved, const Isometry3d& start,
           const CloudFitOptions& options) {
  if (!(options.overlap >= 0 && options.overlap <= 1))
    throw Error("registration: expected an overlap of 0 to 1");
  if (!(options.reach >= 0 && options.reach <= largestCoordinate))
    throw Error("registration: expected a reach of 0 or more");
  if (!start.matrix().allFinite())
    throw ShownError({Shown::tr("registration: the starting motion is not finite")});
  if (fixed.size() < 20 || moved.size() < 20)
    throw ShownError({Shown::tr(
        "a scan of under 20 points cannot be registered: check that it is the right one")});
}

[[noreturn]] void refuseApart() {
  throw ShownError({Shown::tr(
      "the scans do not overlap where they lie: give three pairs of targets, or more reach")});
}

/// What lengths are measured by.
struct Lengths {
  double spacing; // the larger of the two clouds [L]
  double size;    // of half of the fixed cloud without its far points [L]
  double reach;   // at the coarsest scale [L]
};

Lengths lengthsOf(const PointCloud& fixed, const PointCloud& moved, double reach,
                  const Progress& progress) {
  const double spacing = std::max(pointSpacing(fixed.positions(), progress.part(0, 0.5)),
                                  pointSpacing(moved.positions(), progress.part(0.5, 1)));
  if (!(spacing > 0))
    throw ShownError(
        {Shown::tr("the points of a scan all lie at one place: check that it is the right one")});
  const double diagonal = plantBounds(fixed, {}, progress).diagonal().norm();
  return {.spacing = spacing, .size = diagonal / 2, .reach = reach > 0 ? reach : 0.1 * diagonal};
}

/// Steps at one scale until the last is under a fiftieth of `edge`, which its points are apart.
CloudFit stepped(CloudFit fit, const CloudMatching& matching, const CloudFitOptions& options,
                 double edge, double reach, double agreement, double size,
                 const Progress& progress) {
  fit.converged = false;
  for (int i = 0; i < mostSteps && !fit.converged; ++i) {
    const std::vector<CloudPair> pairs =
        trimmed(matching.pairs(fit.motion, reach, agreement, progress), options.overlap);
    if (pairs.size() < fewestPairs) refuseApart();
    Vector3d center = Vector3d::Zero();
    for (const CloudPair& pair : pairs)
      center += pair.place / static_cast<double>(pairs.size());
    MotionStep step(center, size);
    for (const CloudPair& pair : pairs)
      step.add(pair.place, pair.target, pair.across);
    const Isometry3d next = step.motion(true);
    fit.motion = next * fit.motion;
    fit.converged = step.lengthOf(next) < 0.02 * edge;
    ++fit.iterations;
    progress.update(static_cast<double>(i + 1) / mostSteps);
  }
  return fit;
}

/// With how much overlaps in the end, and how well.
CloudFit judged(CloudFit fit, const CloudMatching& matching, double spacing,
                const Progress& progress) {
  const std::vector<CloudPair> pairs = matching.pairs(fit.motion, nearest * spacing, 0, progress);
  double squares = 0;
  std::size_t near = 0;
  for (const CloudPair& pair : pairs) {
    if (!std::isfinite(pair.squared)) continue;
    ++near;
    squares += squaredAcross(pair);
  }
  fit.overlap = static_cast<double>(near) / static_cast<double>(pairs.size());
  if (fit.overlap < leastOverlap) refuseApart();
  fit.rms = std::sqrt(squares / static_cast<double>(near));
  return fit;
}

} // namespace

CloudFit fitClouds(const PointCloud& fixed, const PointCloud& moved, const Isometry3d& start,
                   const CloudFitOptions& options, const Progress& progress) {
  check(fixed, moved, start, options);
  const Lengths lengths = lengthsOf(fixed, moved, options.reach, progress.part(0, 0.06));
  // About the origin of the fixed cloud, where floats are fine.
  const Eigen::Translation3d toFixed(fixed.origin());
  const Eigen::Translation3d toMoved(moved.origin());
  CloudFit fit{.motion = toFixed.inverse() * start * toMoved};
  double reach = lengths.reach;
  for (double scale = coarsest; scale >= 1; scale /= 2) {
    const double from = 0.06 + 0.12 * (std::log2(coarsest) - std::log2(scale));
    const Progress here = progress.part(from, scale == 1 ? 1 : from + 0.12);
    const double edge = scale * lengths.spacing;
    const SampledCloud ofFixed =
        sampled(fixed, edge, std::numeric_limits<Index>::max(), here.part(0, 0.3));
    const SampledCloud ofMoved = sampled(moved, edge, mostSamples, here.part(0.3, 0.5));
    const bool isTooCoarse = std::min(ofFixed.points.cols(), ofMoved.points.cols()) < fewestPoints;
    if (scale > 1 && isTooCoarse) continue;
    const CloudMatching matching(ofFixed, ofMoved, here);
    const double agreement =
        scale > 2 ? 0 : agreementOf(matching, fit.motion, std::max(reach, 3 * edge), here);
    fit = stepped(fit, matching, options, edge, std::max(reach, 3 * edge), agreement, lengths.size,
                  here.part(0.5, 1));
    if (scale == 1) fit = judged(fit, matching, lengths.spacing, here);
    reach /= 2;
  }
  fit.motion = toFixed * fit.motion * toMoved.inverse();
  // Many products: a rotation again, to the last digit.
  fit.motion.linear() = Eigen::Quaterniond(fit.motion.linear()).normalized().toRotationMatrix();
  progress.update(1);
  return fit;
}

} // namespace espalier
