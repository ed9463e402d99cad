#include "core/pipeline/needed_points.h"

#include "core/base/error.h"
#include "core/clean/thinning.h"
#include "core/decide/error_ratings.h"
#include "core/graph/turn_upright.h"
#include "core/pipeline/pipeline.h"
#include "core/pipeline/pipeline_start.h"
#include "core/skeleton/length_along.h"
#include "core/skeleton/point_distances.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <utility>

namespace espalier {
namespace {

constexpr double leastThickness = 5; // spacings of points that are left, across the thin wood
constexpr Eigen::Index fewestTried = 2000;
constexpr double leastGain = 0.01;          // of the share, by a half step: less may be chance
constexpr Eigen::Index mostRated = 500'000; // that the ratings look at

/// Some of the points of a plant, and what they are like.
struct Kept {
  std::vector<bool> isLeftOut; // by point of the plant
  std::shared_ptr<const PointCloud> points;
  PlantScale scale;
  double spacing = 0; // least between those that are left [L]; 0: as they are

  [[nodiscard]] double thickness() const { return scale.thickness / scale.spacing; } // [spacings]
};

/// Tries how a plant is reconstructed of fewer points.
class NeededPoints {
public:
  NeededPoints(const std::shared_ptr<const PointCloud>& plant, const PlantScale& scale, UpAxis up)
      : plant_(plant),
        up_(up), all_{std::vector<bool>(static_cast<std::size_t>(plant->size()), false), plant,
                      scale} {
    options_.set("thin.method=none");
    options_.up = up;
  }

  /// What the best of them leaves out.
  [[nodiscard]] std::vector<bool> leftOutByBest(const Progress& progress) {
    const std::vector<Kept> tried = doubled(progress);
    const auto rated = std::ranges::find_if(
        tried, [](const Kept& kept) { return kept.points->size() <= mostRated; });
    if (tried.size() == 1 || rated == tried.end()) return all_.isLeftOut; // none
    rated_ = *rated;
    index_ = std::make_unique<const SpatialIndex>(rated_.points->positions(), progress.part(0, 0));
    auto best = tried.end();
    double share = -1;
    double done = 0;
    for (auto kept = tried.end(); kept != rated;) {
      --kept;
      // Each has about four times the points of the one before.
      const double next = done + (0.9 - done) * (kept == rated ? 1 : 0.2);
      const double found = shareRight(*kept, progress.part(done, next));
      done = next;
      if (found <= share) break;
      share = found;
      best = kept;
    }
    if (best == tried.end()) return all_.isLeftOut;
    std::vector<bool> isLeftOut = best->isLeftOut;
    if (best == rated) return isLeftOut; // the next ones would take longest, and gain least
    for (const double factor : {1 / std::numbers::sqrt2, std::numbers::sqrt2}) {
      Kept between = keptAt(best->spacing * factor, progress.part(0.9, 0.9));
      if (!isEnough(between)) continue;
      const double found = shareRight(between, progress.part(0.9, 1));
      if (found <= share + leastGain) continue;
      share = found;
      isLeftOut = std::move(between.isLeftOut);
    }
    progress.update(1);
    return isLeftOut;
  }

private:
  /// Are there points enough, and some across the thin wood?
  [[nodiscard]] static bool isEnough(const Kept& kept) {
    return kept.points->size() >= fewestTried && kept.thickness() >= leastThickness;
  }

  [[nodiscard]] Kept keptAt(double spacing, const Progress& progress) const {
    Kept kept{thinnedBySpacing(plant_->positions(), {.spacing = spacing}, progress), nullptr, {}};
    std::vector<Eigen::Index> left;
    for (std::size_t i = 0; i < kept.isLeftOut.size(); ++i)
      if (!kept.isLeftOut[i]) left.push_back(static_cast<Eigen::Index>(i));
    kept.points = someOf(*plant_, left);
    kept.scale = scaleOf(*kept.points, {}, up_, progress);
    kept.spacing = spacing;
    return kept;
  }

  /// At spacings that double from that of the plant on, as long as its thin wood has some across
  /// it.
  [[nodiscard]] std::vector<Kept> doubled(const Progress& progress) const {
    std::vector<Kept> tried{all_};
    for (double spacing = 2 * all_.scale.spacing;; spacing *= 2) {
      Kept kept = keptAt(spacing, progress.part(0, 0));
      if (!isEnough(kept)) return tried;
      tried.push_back(std::move(kept));
    }
  }

  /// The share of the length of the skeleton of `kept` that is probably right; -1: it has none.
  [[nodiscard]] double shareRight(const Kept& kept, const Progress& progress) const {
    std::shared_ptr<const Skeleton> skeleton;
    try {
      skeleton = Pipeline().run(kept.points, options_, progress.part(0, 0.6)).skeleton;
    } catch (const Error&) { // too few points for a plant
      return -1;
    }
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
  PipelineOptions options_;
  Kept all_;
  Kept rated_;                                // by whose points skeletons are rated
  std::unique_ptr<const SpatialIndex> index_; // of its points
};

} // namespace

std::vector<bool> notNeeded(const PointCloud& cloud, const std::vector<Eigen::Index>& plant,
                            const PlantScale& scale, UpAxis up, const Progress& progress) {
  progress.check();
  return NeededPoints(someOf(cloud, plant), scale, up).leftOutByBest(progress);
}

} // namespace espalier
