#include "core/pipeline/used_densities.h"

#include "core/cloud/repeated_points.h"
#include "core/pipeline/method_parts.h"
#include "core/pipeline/pipeline_start.h"
#include "core/pipeline/step_graph.h"

#include <limits>

namespace espalier {

std::vector<float> countedDensities(const PipelineState& smoothed, const DensityValues& values,
                                    const Progress& progress) {
  const NeighborhoodGraph graph((*smoothed.contracted)(Eigen::all, keptPoints(smoothed)),
                                values.neighbors, progress.part(0, 0.6));
  return radiusDensities(graph, static_cast<float>(values.radius), progress.part(0.6, 1));
}

std::optional<std::vector<float>> densitiesUsed(const std::shared_ptr<const PointCloud>& cloud,
                                                const PipelineOptions& options,
                                                const PlantScale& scale, const Progress& progress) {
  requireKnown(options);
  if (!chosenFor(contractionStep(), options, scale).probe().density) return std::nullopt;
  PipelineState state = cleanedState(cloud, options, scale, progress.part(0, 0.3));
  runSteps(stepsBetween(StepResult::cleaned, StepResult::smoothed, options, state.extent.scale),
           state, progress.part(0.3, 0.4));
  const auto used = chosenFor(contractionStep(), options, state.extent.scale).probe().density;
  const std::vector<float> densities =
      normalizedDensities(countedDensities(state, *used, progress.part(0.4, 1)), used->measure);
  std::vector<float> byPoint(static_cast<std::size_t>(cloud->size()),
                             std::numeric_limits<float>::quiet_NaN());
  std::size_t next = 0;
  for (const Eigen::Index point : keptPoints(state))
    byPoint[static_cast<std::size_t>(point)] = densities[next++];
  const auto isKept = [&](Eigen::Index point) {
    return !state.isLeftOut[static_cast<std::size_t>(point)];
  };
  forEachRepeated(*cloud, isKept, [&](Eigen::Index point, Eigen::Index before) {
    byPoint[static_cast<std::size_t>(point)] = byPoint[static_cast<std::size_t>(before)];
  });
  return byPoint;
}

} // namespace espalier
