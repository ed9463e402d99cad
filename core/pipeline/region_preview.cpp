#include "core/pipeline/region_preview.h"

#include "core/base/spatial_index.h"
#include "core/cloud/point_cloud.h"
#include "core/graph/components.h"
#include "core/graph/geodesic.h"
#include "core/pipeline/method_parts.h"
#include "core/pipeline/pipeline_start.h"
#include "core/pipeline/plant_scale.h"
#include "core/pipeline/recent.h"
#include "core/pipeline/region_skeleton.h"
#include "core/pipeline/step_graph.h"
#include "core/pipeline/used_densities.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <utility>

namespace espalier {
namespace {

/// How far around the ball points are looked at [L].
/// @param reach  of all that moves points, together
double marginOf(double reach, const Ball& ball, double spacing) {
  constexpr double least = 8; // in point spacings: for those that look at nearest points
  constexpr double alwaysAllowed = 20;
  const double most = std::max(ball.radius / 2, alwaysAllowed * spacing);
  return std::clamp(2 * reach, least * spacing, most);
}

} // namespace

/// What is computed once, of the whole scan.
struct RegionPreviewer::Whole {
  using IsLeftOut = std::shared_ptr<const std::vector<bool>>; // by point: set aside, or cleaned
  using Cleaning = PipelineOptions;                           // of the steps that clean alone
  using Smoothing = PipelineOptions;                          // of these, and those that smooth
  struct Cleaned {
    IsLeftOut isLeftOut;
    PlantScale scale; // of what is left
  };
  struct DensityKey {
    Smoothing smoothing;
    DensityValues values;
    bool operator==(const DensityKey&) const = default;
  };

  std::shared_ptr<const PointCloud> cloud;
  PointSet leftOut;
  PlantScale scale;
  PipelineOptions start; // its root and up axis
  std::mutex mutex;      // of all below
  std::unique_ptr<const SpatialIndex> index;
  Recent<Cleaning, Cleaned> cleaned;
  Recent<DensityKey, DensityLevels> levels;
  std::shared_ptr<const std::vector<float>> distanceToRoot; // by point; infinite if set aside

  const SpatialIndex& indexed(const Progress& progress) {
    const std::scoped_lock lock(mutex);
    return indexedHere(progress);
  }

  const SpatialIndex& indexedHere(const Progress& progress) { // pre: the mutex is held
    if (!index) index = std::make_unique<const SpatialIndex>(cloud->positions(), progress);
    return *index;
  }

  /// What of these options is of the steps up to those that make `last`.
  [[nodiscard]] PipelineOptions upTo(StepResult last, const PipelineOptions& options) const {
    PipelineOptions result = start;
    for (const Step& step : pipelineSteps()) {
      if (step.makes > last) continue;
      if (const auto method = options.methods.find(step.name); method != options.methods.end())
        result.methods.insert(*method);
      if (const auto set = options.settings.find(step.name); set != options.settings.end())
        result.settings.insert(*set);
    }
    return result;
  }

  Cleaned cleanedBy(const Cleaning& cleaning, const Progress& progress) {
    const std::scoped_lock lock(mutex);
    if (const Cleaned* known = cleaned.find(cleaning)) return *known;
    PipelineState state = cleanedState(cloud, cleaning, scale, progress);
    return cleaned.keep(cleaning,
                        {std::make_shared<const std::vector<bool>>(std::move(state.isLeftOut)),
                         state.extent.scale});
  }

  /// None for methods that do not follow densities, or where no points are left.
  std::optional<DensityLevels> densityLevels(const Smoothing& smoothing, const Cleaned& left,
                                             const ChosenMethod& contraction,
                                             const Progress& progress) {
    const std::optional<DensityValues> used = contraction.probe().density;
    if (!used) return std::nullopt;
    const DensityKey key{smoothing, *used};
    const std::scoped_lock lock(mutex);
    if (const DensityLevels* known = levels.find(key)) return *known;
    PipelineState state = firstState(cloud, leftOut);
    state.isLeftOut = *left.isLeftOut;
    state.made = StepResult::cleaned;
    runSteps(stepsBetween(StepResult::cleaned, StepResult::smoothed, smoothing, left.scale), state,
             progress.part(0, 0.5));
    const std::vector<float> densities = countedDensities(state, *used, progress.part(0.5, 1));
    if (densities.empty()) return std::nullopt;
    return levels.keep(key, levelsOf(densities, used->measure));
  }

  /// Along links between the points that were not set aside, over the shortest of the gaps.
  std::shared_ptr<const std::vector<float>> distances(const Progress& progress) {
    constexpr int linksPerPoint = 7;
    const std::scoped_lock lock(mutex);
    if (distanceToRoot) return distanceToRoot;
    const PipelineState all = firstState(cloud, leftOut);
    const std::vector<Eigen::Index> kept = keptPoints(all);
    const Eigen::Matrix3Xf points = cloud->positions()(Eigen::all, kept);
    std::vector<float> result(static_cast<std::size_t>(cloud->size()),
                              std::numeric_limits<float>::infinity());
    if (!kept.empty()) {
      const NeighborhoodGraph parts(points, linksPerPoint, progress);
      const PlantExtent extent = plantExtent(*cloud, indexedHere(progress), leftOut, start.up);
      const Eigen::Index root = rootPoint(all, start, extent.lowest);
      const auto place = std::ranges::lower_bound(kept, root) - kept.begin();
      const Geodesics paths = geodesics(
          joined(parts, points, std::numeric_limits<float>::max(), progress), {place}, 1, progress);
      for (std::size_t i = 0; i < kept.size(); ++i)
        result[static_cast<std::size_t>(kept[i])] = paths.distance[i];
    }
    return distanceToRoot = std::make_shared<const std::vector<float>>(std::move(result));
  }
};

namespace {

/// A part of the scan as it goes through the steps.
struct Region {
  std::vector<Eigen::Index> columns; // of its cloud in that of the whole: those that are kept
  PipelineState state;
  RegionPreview preview;
};

std::vector<float> atColumns(const std::vector<float>& values,
                             const std::vector<Eigen::Index>& columns) {
  std::vector<float> result;
  result.reserve(columns.size());
  for (const Eigen::Index column : columns)
    result.push_back(values[static_cast<std::size_t>(column)]);
  return result;
}

/// The places of the points in the ball: those that cleaning leaves out stay, those at the place of
/// another go with it.
Eigen::Matrix3Xf placesOf(const Region& region, const PointCloud& cloud) {
  Eigen::Matrix3Xf places = cloud.positions()(Eigen::all, region.preview.points);
  auto column = region.columns.begin();
  for (std::size_t i = 0; i < region.preview.points.size(); ++i) {
    const Eigen::Index point = region.preview.points[i];
    column = std::lower_bound(column, region.columns.end(), point);
    const auto place = static_cast<Eigen::Index>(i);
    if (column != region.columns.end() && *column == point)
      places.col(place) = region.state.contracted->col(column - region.columns.begin());
    else if (i > 0 &&
             cloud.positions().col(point) == cloud.positions().col(region.preview.points[i - 1]))
      places.col(place) = places.col(place - 1);
  }
  return places;
}

} // namespace

struct RegionPreviewer::Regions {
  /// The points of the ball and its margin, contracted.
  static Region contracted(Whole& whole, const Ball& ball, const PipelineOptions& options,
                           const Progress& progress) {
    requireKnown(options);
    const Whole::Cleaned left =
        whole.cleanedBy(whole.upTo(StepResult::cleaned, options), progress.part(0, 0.2));
    const PlantScale& scale = left.scale;
    const ChosenMethod contraction = chosenFor(contractionStep(), options, scale);
    const std::vector<ChosenStep> moving =
        stepsBetween(StepResult::cleaned, StepResult::contracted, options, scale);
    double reach = 0;
    for (const ChosenStep& step : moving)
      reach += step.method.probe().reach;
    Region region =
        around(whole, ball, marginOf(reach, ball, scale.spacing), *left.isLeftOut, progress);
    region.state.extent.scale = scale; // of what cleaning leaves
    region.state.densityLevels = whole.densityLevels(whole.upTo(StepResult::smoothed, options),
                                                     left, contraction, progress.part(0.2, 0.3));
    if (region.columns.size() >= 2) {
      if (contraction.method->seesRoot) region.state.root = nearestToRoot(whole, region, progress);
      runSteps(moving, region.state, progress.part(0.3, 1));
    }
    region.preview.contracted = placesOf(region, *whole.cloud);
    return region;
  }

private:
  static Region around(Whole& whole, const Ball& ball, double margin,
                       const std::vector<bool>& isLeftOut, const Progress& progress) {
    Region region;
    const Eigen::Vector3f center = (ball.center - whole.cloud->origin()).cast<float>();
    for (const Neighbor& found :
         whole.indexed(progress).within(center, static_cast<float>(ball.radius + margin))) {
      if (!isLeftOut[static_cast<std::size_t>(found.index)]) region.columns.push_back(found.index);
      if (ball.contains(whole.cloud->position(found.index)) && !whole.leftOut.contains(found.index))
        region.preview.points.push_back(found.index);
    }
    std::ranges::sort(region.columns);
    std::ranges::sort(region.preview.points);
    region.state = firstState(someOf(*whole.cloud, region.columns), PointSet());
    region.state.made = StepResult::cleaned; // as the whole was
    return region;
  }

  static Eigen::Index nearestToRoot(Whole& whole, const Region& region, const Progress& progress) {
    const std::vector<float> distances = atColumns(*whole.distances(progress), region.columns);
    return std::ranges::min_element(distances) - distances.begin();
  }
};

RegionPreviewer::RegionPreviewer(std::shared_ptr<const PointCloud> cloud, const PointSet& leftOut,
                                 const PlantScale& scale, UpAxis up,
                                 const std::optional<Eigen::Vector3d>& root)
    : whole_(std::make_unique<Whole>()) {
  whole_->cloud = std::move(cloud);
  whole_->leftOut = leftOut;
  whole_->scale = scale;
  whole_->start.up = up;
  whole_->start.leftOut = whole_->leftOut;
  whole_->start.root = root;
}

RegionPreviewer::~RegionPreviewer() = default;
RegionPreviewer::RegionPreviewer(RegionPreviewer&&) noexcept = default;
RegionPreviewer& RegionPreviewer::operator=(RegionPreviewer&&) noexcept = default;

RegionPreview RegionPreviewer::contracted(const Ball& ball, const PipelineOptions& options,
                                          const Progress& progress) const {
  return Regions::contracted(*whole_, ball, options, progress).preview;
}

RegionPreview RegionPreviewer::reconstructed(const Ball& ball, const PipelineOptions& options,
                                             const Progress& progress) const {
  Region region = Regions::contracted(*whole_, ball, options, progress.part(0, 0.5));
  if (region.columns.size() >= 2)
    region.preview.skeleton =
        skeletonOfRegion(region.state, atColumns(*whole_->distances(progress), region.columns),
                         ball, options, progress.part(0.5, 1));
  return std::move(region.preview);
}

Ball RegionPreviewer::ballWith(const Eigen::Vector3d& center, Eigen::Index count) const {
  const SpatialIndex& index = whole_->indexed({});
  const auto wanted = static_cast<std::size_t>(std::max<Eigen::Index>(count, 1));
  const auto total = static_cast<std::size_t>(whole_->cloud->size());
  const Eigen::Vector3f place = (center - whole_->cloud->origin()).cast<float>();
  const double all =
      whole_->cloud->bounds().exteriorDistance(center) + whole_->cloud->bounds().diagonal().norm();
  double reach = whole_->scale.spacing * std::sqrt(static_cast<double>(wanted));
  std::vector<Neighbor> found;
  do {
    reach *= 1.5;
    found = index.within(place, static_cast<float>(reach));
  } while (found.size() <= std::min(wanted, total - 1) && reach <= all);
  if (found.size() <= wanted) return {center, all};
  std::vector<double> distances;
  distances.reserve(found.size());
  for (const Neighbor& one : found)
    distances.push_back((whole_->cloud->position(one.index) - center).norm());
  const auto next = distances.begin() + static_cast<std::ptrdiff_t>(wanted);
  std::ranges::nth_element(distances, next);
  const double within = *std::max_element(distances.begin(), next);
  // Between the last that is in and the first that is not; below both if they are as far off.
  return {center, within < *next ? (within + *next) / 2 : within * (1 - 1e-9)};
}

} // namespace espalier
