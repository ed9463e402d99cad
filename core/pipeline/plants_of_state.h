#pragma once

#include "core/clean/plants.h"
#include "core/pipeline/registry.h"

namespace espalier {

// What the method geodesic of the step plant finds, for those who want all plants.

/// The plants among the points that are kept, one entry per kept point. Bases are upright, about
/// the origin of the cloud.
/// @param bases  where plants stand [L], frame of the file; none: they are looked for
/// @throws as plantsAmong()
[[nodiscard]] PlantParts plantsOfState(const PipelineState& state,
                                       const std::vector<Eigen::Vector3d>& bases,
                                       const PlantsOptions& options, const Progress& progress);

/// @param values of the options of the method
[[nodiscard]] PlantsOptions plantsOptionsOf(const std::vector<double>& values);

} // namespace espalier
