#pragma once

#include "core/cloud/point_cloud.h"
#include "core/pipeline/pipeline.h"
#include "core/skeleton/skeleton.h"

#include <nlohmann/json_fwd.hpp>

#include <utility>
#include <vector>

namespace espalier {

/// Keys: points, bounds.{minimum,maximum}, origin, spacing, has_colors, has_intensities.
[[nodiscard]] nlohmann::ordered_json statistics(const PointCloud& cloud);

/// Keys: nodes, roots, tips, successor_edges, branching_edges, length, axes_per_order,
/// bounds.{minimum,maximum}, largest_radius, findings.
[[nodiscard]] nlohmann::ordered_json statistics(const Skeleton& skeleton);

/// Keys: scale.{spacing,height}, steps[].{step,method,options}, seconds.
[[nodiscard]] nlohmann::ordered_json
statistics(const Reconstruction& reconstruction,
           const std::vector<std::pair<std::string, double>>& stageSeconds);

} // namespace espalier
