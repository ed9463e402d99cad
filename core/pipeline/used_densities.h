#pragma once

#include "core/pipeline/pipeline_options.h"

#include <memory>
#include <optional>
#include <vector>

namespace espalier {

// The densities that an adaptive contraction follows: those that its curve turns into radii.

/// Of the points that cleaning kept, in their order, where smoothing left them, as counted:
/// core/graph/densities.h.
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] std::vector<float> countedDensities(const PipelineState& smoothed,
                                                  const DensityValues& values,
                                                  const Progress& progress = {});

/// The normalized densities of all points of a scan for the contraction that is chosen, by point;
/// not a number for points that are left out. None if it follows no density.
/// @throws Error     if an option is unknown or out of range
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] std::optional<std::vector<float>>
densitiesUsed(const std::shared_ptr<const PointCloud>& cloud, const PipelineOptions& options,
              const PlantScale& scale, const Progress& progress = {});

} // namespace espalier
