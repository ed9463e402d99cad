#include "core/pipeline/pipeline_start.h"

#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/cloud/far_points.h"
#include "core/cloud/repeated_points.h"
#include "core/pipeline/method_parts.h"
#include "core/pipeline/plant_scale.h"
#include "core/pipeline/step_graph.h"

#include <cmath>
#include <utility>

namespace espalier {

std::shared_ptr<const PointCloud> someOf(const PointCloud& cloud,
                                         const std::vector<Eigen::Index>& points) {
  return std::make_shared<const PointCloud>(
      StoredPoints{.positions = cloud.positions()(Eigen::all, points),
                   .origin = cloud.origin(),
                   .colors = {},
                   .intensities = {},
                   .fileOrder = std::vector<std::uint32_t>(points.size())});
}

PipelineState firstState(const std::shared_ptr<const PointCloud>& cloud, const PointSet& leftOut) {
  return {.cloud = cloud,
          .isLeftOut = notCounted(*cloud, leftOut),
          .contracted = {cloud, &cloud->positions()}, // of the cloud: no copy
          .root = 0};
}

PipelineState firstState(const std::shared_ptr<const PointCloud>& cloud,
                         const PipelineOptions& options) {
  PipelineState state = firstState(cloud, options.leftOut);
  state.up = options.up;
  state.chosenRoot = options.root;
  state.organs = options.organs;
  return state;
}

PipelineState cleanedState(const std::shared_ptr<const PointCloud>& cloud,
                           const PipelineOptions& options, const PlantScale& scale,
                           const Progress& progress) {
  requireKnown(options);
  PipelineState state = firstState(cloud, options);
  state.extent.scale = scale;
  runCleaning(state, options, progress);
  return state;
}

PipelineOptions withScanCleaned(const std::shared_ptr<const PointCloud>& cloud,
                                const PipelineOptions& wanted, const Progress& progress) {
  const PipelineOptions options = withoutTrials(wanted);
  std::vector<const Step*> changing;
  for (const Step& step : pipelineSteps())
    if (chosenMethod(step, options).changesScale) changing.push_back(&step);
  if (changing.empty()) return options;
  PipelineOptions cleaned = options;
  const PlantScale scale = scaleOf(*cloud, options.leftOut, options.up, progress);
  const PipelineState state = cleanedState(cloud, options, scale, progress);
  if (state.apart) cleaned.leftOut = options.leftOut | *state.apart;
  for (const Step* step : changing) {
    cleaned.methods[step->name] = "none";
    cleaned.settings.erase(step->name);
  }
  return cleaned;
}

Eigen::Index rootPoint(const PipelineState& cleaned, const PipelineOptions& options, float lowest) {
  const std::vector<Eigen::Index> kept = keptPoints(cleaned);
  if (kept.empty()) return 0;
  if (!options.root) return footAmong(kept, *cleaned.cloud, options.leftOut, options.up, lowest);
  const Eigen::Matrix3Xf points = cleaned.cloud->positions()(Eigen::all, kept);
  const Eigen::Vector3f root = (*options.root - cleaned.cloud->origin()).cast<float>();
  return kept[static_cast<std::size_t>(nearestPoint(points, root))];
}

void requireNearRoot(const PointCloud& cloud, const PipelineOptions& options) {
  if (!options.root) return;
  const Eigen::AlignedBox3d box = plantBounds(cloud, options.leftOut);
  if (box.isEmpty()) return; // that no point is left is said when they are measured
  const double away = box.exteriorDistance(*options.root);
  if (away > box.diagonal().norm())
    throw ShownError(
        {options.leftOut.isEmpty()
             ? Shown::tr("the root lies %1 away from the scan: give a place in its coordinates")
             : Shown::tr("the root lies %1 away from the points that are not set aside: give a "
                         "place near them"),
         {plainDecimal(std::round(away))}});
}

} // namespace espalier
