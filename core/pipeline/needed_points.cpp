#include "core/pipeline/needed_points.h"

#include "core/base/error.h"
#include "core/clean/thinning.h"
#include "core/decide/error_ratings.h"
#include "core/graph/turn_upright.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/pipeline_start.h"
#include "core/skeleton/branch_end.h"
#include "core/skeleton/length_along.h"
#include "core/skeleton/point_distances.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <numeric>
#include <utility>

namespace espalier {
namespace {

constexpr double widening = std::numbers::sqrt2; // of the spacing, from a level to the next
constexpr double wideness = 10;             // spacings across thin wood: skeletons double inside it
constexpr std::ptrdiff_t partSize = 20'000; // points in which ends are counted
constexpr Eigen::Index mostParts = 5;
constexpr Eigen::Index fewestWithoutNeedles = 5000; // points
constexpr double needleLoss = 1.7;                  // ends, by those at the next spacing
constexpr double mostScatter = 1.5;          // spacings: more is evened out by all points alone
constexpr std::size_t fewestEnds = 40;       // needles are many; of few ends, half may go by chance
constexpr Eigen::Index fewestTried = 2000;   // points
constexpr Eigen::Index mostRated = 500'000;  // points that the ratings look at
constexpr Eigen::Index mostUsed = 2'000'000; // points, where those that are rated are too few
constexpr double leastThickness = 5;         // spacings of points that are left, across thin wood
constexpr double leastGain = 0.01;           // of the share, by a half step: less may be chance

/// Some of the points of a plant, and what they are like.
struct Level {
  double step = 1;             // least spacing, in spacings of the plant
  std::vector<bool> isLeftOut; // by point of the plant
  std::shared_ptr<const PointCloud> points;
  PlantScale scale;
};

/// Those of the points of a cloud that are nearest to one of them.
std::shared_ptr<const PointCloud> around(Eigen::Index center, const PointCloud& cloud) {
  const Eigen::Matrix3Xf& positions = cloud.positions();
  std::vector<Eigen::Index> points(static_cast<std::size_t>(positions.cols()));
  std::iota(points.begin(), points.end(), Eigen::Index{0});
  if (std::ssize(points) > partSize) {
    const Eigen::Vector3f middle = positions.col(center);
    const auto distance = [&](Eigen::Index i) {
      return std::pair((positions.col(i) - middle).squaredNorm(), i);
    };
    std::ranges::nth_element(points, points.begin() + partSize, {}, distance);
    points.resize(static_cast<std::size_t>(partSize));
    std::ranges::sort(points);
  }
  return someOf(cloud, points);
}

std::shared_ptr<const PointCloud> keptOf(const PointCloud& cloud,
                                         const std::vector<bool>& isLeftOut) {
  std::vector<Eigen::Index> left;
  for (std::size_t i = 0; i < isLeftOut.size(); ++i)
    if (!isLeftOut[i]) left.push_back(static_cast<Eigen::Index>(i));
  return someOf(cloud, left);
}

/// Tries how a plant is reconstructed of fewer points.
class NeededPoints {
public:
  NeededPoints(const std::shared_ptr<const PointCloud>& plant, const PlantScale& scale, UpAxis up)
      : plant_(plant), up_(up), spacing_(scale.spacing) {
    finest_.isLeftOut.resize(static_cast<std::size_t>(plant->size()), false);
    finest_.points = plant;
    finest_.scale = scale;
    options_.set("thin.method=none");
    options_.up = up;
  }

  /// By point of the plant.
  [[nodiscard]] std::vector<bool> leftOut(const Progress& progress) {
    const bool isWide = finest_.scale.thickness > wideness * spacing_;
    if (isWide) return leftOutByBest(progress);
    widenPastNeedles(progress);
    progress.update(1);
    return finest_.isLeftOut;
  }

private:
  /// Needles and the like have ends where points are dense enough to show each of them: where they
  /// are a little farther apart, there are far fewer ends.
  void widenPastNeedles(const Progress& progress) {
    for (double done = 0;; done += 0.5 * (1 - done)) {
      if (finest_.scale.scatter > mostScatter * finest_.scale.spacing) return;
      if (!showsNeedles(progress.part(done, done + 0.5 * (1 - done)))) return;
      Level next = levelAt(widening * finest_.step, progress.part(1, 1));
      if (next.points->size() < fewestWithoutNeedles) return;
      finest_ = std::move(next);
    }
  }

  /// Does the finest level? By some parts of it.
  [[nodiscard]] bool showsNeedles(const Progress& progress) const {
    const Eigen::Index size = finest_.points->size();
    const Eigen::Index parts = std::clamp<Eigen::Index>(size / partSize, 1, mostParts);
    std::size_t ends = 0, fewer = 0;
    for (Eigen::Index i = 0; i < parts; ++i) {
      const auto of = static_cast<double>(parts);
      const Progress now =
          progress.part(static_cast<double>(i) / of, static_cast<double>(i + 1) / of);
      const auto part = around((2 * i + 1) * size / (2 * parts), *finest_.points);
      ends += endsOf(part, now.part(0, 0.6));
      const std::vector<bool> isOut = thinnedBySpacing(
          part->positions(), {.spacing = widening * finest_.step * spacing_}, now.part(0.6, 0.6));
      fewer += endsOf(keptOf(*part, isOut), now.part(0.6, 1));
    }
    return ends >= fewestEnds &&
           static_cast<double>(ends) > needleLoss * static_cast<double>(fewer);
  }

  /// What the best level leaves out. The widest spacings are tried first, until one is worse, then
  /// those half a step beside it.
  [[nodiscard]] std::vector<bool> leftOutByBest(const Progress& progress) {
    const std::vector<Level> tried = doubled(progress);
    const auto rated = std::ranges::find_if(
        tried, [](const Level& level) { return level.points->size() <= mostRated; });
    if (tried.size() == 1 || rated == tried.end()) return finest_.isLeftOut; // none
    rated_ = *rated;
    index_ = std::make_unique<const SpatialIndex>(rated_.points->positions(), progress.part(0, 0));
    auto best = tried.end();
    double share = -1;
    double done = 0;
    for (auto level = tried.end(); level != rated;) {
      --level;
      // Each has about four times the points of the one before.
      const double next = done + (0.9 - done) * (level == rated ? 1 : 0.2);
      const double found = shareRight(*level, progress.part(done, next));
      done = next;
      if (found <= share) break;
      share = found;
      best = level;
    }
    if (best == tried.end()) return finest_.isLeftOut;
    const bool isFinest = best == rated; // of those that can be rated
    if (isFinest) return plant_->size() <= mostUsed ? finest_.isLeftOut : best->isLeftOut;
    std::vector<bool> isLeftOut = best->isLeftOut;
    for (const double factor : {1 / widening, widening}) {
      Level between = levelAt(best->step * factor, progress.part(0.9, 0.9));
      if (!isEnough(between)) continue;
      const double found = shareRight(between, progress.part(0.9, 1));
      if (found <= share + leastGain) continue;
      share = found;
      isLeftOut = std::move(between.isLeftOut);
    }
    progress.update(1);
    return isLeftOut;
  }

  /// Are there points enough, and some across the thin wood? A skeleton of a few edges says
  /// nothing: of so many points it is of all of the plant.
  [[nodiscard]] bool isEnough(const Level& level) const {
    return level.points->size() >= std::max(fewestTried, plant_->size() / 100) &&
           level.scale.thickness >= leastThickness * level.scale.spacing;
  }

  /// At spacings that double from that of the plant on, as long as its thin wood has some across
  /// it.
  [[nodiscard]] std::vector<Level> doubled(const Progress& progress) const {
    std::vector<Level> tried{finest_};
    for (double step = 2 * finest_.step;; step *= 2) {
      Level level = levelAt(step, progress.part(0, 0));
      if (!isEnough(level)) return tried;
      tried.push_back(std::move(level));
    }
  }

  [[nodiscard]] Level levelAt(double step, const Progress& progress) const {
    Level level{.step = step, .isLeftOut = {}, .points = {}, .scale = {}};
    level.isLeftOut = thinnedBySpacing(plant_->positions(), {.spacing = step * spacing_}, progress);
    level.points = keptOf(*plant_, level.isLeftOut);
    level.scale = scaleOf(*level.points, {}, up_, progress);
    return level;
  }

  /// Null, where there are too few points for a plant.
  [[nodiscard]] std::shared_ptr<const Skeleton>
  skeletonOf(const std::shared_ptr<const PointCloud>& points, const Progress& progress) const {
    try {
      return Pipeline().run(points, options_, progress).skeleton;
    } catch (const Error&) {
      return nullptr;
    }
  }

  [[nodiscard]] std::size_t endsOf(const std::shared_ptr<const PointCloud>& points,
                                   const Progress& progress) const {
    const auto skeleton = skeletonOf(points, progress);
    return skeleton ? tipCount(*skeleton) : 0;
  }

  /// The share of the length of the skeleton of a level that is probably right; -1: it has none.
  [[nodiscard]] double shareRight(const Level& level, const Progress& progress) const {
    const auto skeleton = skeletonOf(level.points, progress.part(0, 0.6));
    if (!skeleton) return -1;
    const PointDistances distances(rated_.points, rated_.scale.spacing, *skeleton,
                                   progress.part(0.6, 0.7));
    const Eigen::Vector3d up = turnUpright(up_).row(2).transpose();
    const ErrorRatings ratings =
        errorRatings(*skeleton, distances, *index_, rated_.scale, up, progress.part(0.7, 1));
    double right = 0;
    double all = 0;
    for (const NodeId id : skeleton->ids()) {
      const double length = edgeLength(*skeleton, id);
      right += length * (1 - ratings.ofEdges[indexOf(id)]);
      all += length;
    }
    return all > 0 ? right / all : -1;
  }

  std::shared_ptr<const PointCloud> plant_;
  UpAxis up_;
  double spacing_; // of the plant [L]
  PipelineOptions options_;
  Level finest_;
  Level rated_;                               // by whose points skeletons are rated
  std::unique_ptr<const SpatialIndex> index_; // of its points
};

} // namespace

std::vector<bool> notNeeded(const PointCloud& cloud, const std::vector<Eigen::Index>& plant,
                            const PlantScale& scale, UpAxis up, const Progress& progress) {
  progress.check();
  return NeededPoints(someOf(cloud, plant), scale, up).leftOut(progress);
}

} // namespace espalier
