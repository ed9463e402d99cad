#include "core/pipeline/smoothed_scan.h"

#include "core/base/shown.h"
#include "core/contract/fill_holes.h"
#include "core/pipeline/method_parts.h"
#include "core/pipeline/step_graph.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace espalier {
namespace {

/// The points of `cloud` that are kept, at `places`, then those in holes.
PointCloud joined(const PointCloud& cloud, const std::vector<Eigen::Index>& kept,
                  const Eigen::Matrix3Xf& places, const Eigen::Matrix3Xf& added,
                  const Progress& progress) {
  std::vector<Eigen::Index> sources = kept; // of colors and all else
  const SpatialIndex index(places, progress);
  for (const auto& place : added.colwise())
    sources.push_back(kept[static_cast<std::size_t>(index.nearestOne(place)->index)]);
  RawPoints raw{.stations = cloud.stations()};
  const auto put = [&](const auto& place) {
    raw.positions.emplace_back(place.template cast<double>() + cloud.origin());
  };
  for (const auto& place : places.colwise())
    put(place);
  for (const auto& place : added.colwise())
    put(place);
  for (const Eigen::Index source : sources) {
    const auto at = static_cast<std::size_t>(source);
    if (!cloud.colors().empty()) raw.colors.push_back(cloud.colors()[at]);
    if (!cloud.intensities().empty()) raw.intensities.push_back(cloud.intensities()[at]);
    if (!cloud.stationOf().empty()) raw.stationOf.push_back(cloud.stationOf()[at]);
  }
  return PointCloud(std::move(raw), progress);
}

} // namespace

const Step& smoothingStep() {
  static const Step& step = *std::ranges::find(pipelineSteps(), StepResult::smoothed, &Step::makes);
  return step;
}

SmoothedScan smoothedScan(const std::shared_ptr<const PointCloud>& cloud,
                          const PipelineOptions& options, const std::optional<Rule>& widest,
                          const Progress& progress) {
  CleanedScan cleaned = cleanedScan(cloud, options, progress.part(0, 0.2, Shown::tr("Clean")));
  PipelineState& state = cleaned.state;
  SmoothedScan result{.scale = state.extent.scale, .steps = std::move(cleaned.steps)};
  const ChosenStep step{&smoothingStep(), chosenFor(smoothingStep(), options, result.scale)};
  const std::optional<SmoothingShape> shape = shapeOf(step.method);
  assert(shape);
  step.run(state, progress.part(0.2, 0.6, step.step->label));
  const std::vector<Eigen::Index> kept = keptPlaces(state);
  const Eigen::Matrix3Xf places = (*state.contracted)(Eigen::all, kept);
  const Eigen::Matrix3Xf before = cloud->positions()(Eigen::all, kept);
  result.moved = (places - before).cast<double>().colwise().norm().mean();
  Eigen::Matrix3Xf added(3, 0);
  if (widest)
    added = pointsInHoles(places, shape->shape,
                          {.widest = widest->value(result.scale),
                           .spacing = result.scale.spacing,
                           .radius = shape->options.radius},
                          progress.part(0.6, 1, Shown::tr("Fill holes")));
  result.added = added.cols();
  result.points = joined(*cloud, kept, places, added, progress.part(1, 1));
  return result;
}

} // namespace espalier
