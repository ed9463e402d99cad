#pragma once

#include "core/cloud/point_cloud.h"
#include "core/evaluate/study/contraction_quality.h"
#include "core/mtg/mtg.h"
#include "core/pipeline/pipeline.h"
#include "core/skeleton/skeleton.h"

#include <nlohmann/json_fwd.hpp>

#include <utility>
#include <vector>

namespace espalier {

/// Keys: points, bounds.{minimum,maximum}, spacing, far_points, repeated_points, has_colors,
/// has_intensities, stations. The bounds are of all points; far and repeated ones do not count for
/// the spacing.
[[nodiscard]] nlohmann::ordered_json statistics(const PointCloud& cloud);

/// Keys: vertices_per_scale, coarsest first, the scene of scale 0 included; successor_edges and
/// branching_edges, of all scales.
[[nodiscard]] nlohmann::ordered_json statistics(const Mtg& mtg);

/// Keys: nodes, roots, tips, successor_edges, branching_edges, length, axes_per_order,
/// bounds.{minimum,maximum}, largest_radius, findings.
[[nodiscard]] nlohmann::ordered_json statistics(const Skeleton& skeleton);

/// Keys: scale.{spacing,height}, steps[].{step,method,options}, radius_sources.{measured,
/// corrected,extrapolated}: how many nodes have each, seconds.
[[nodiscard]] nlohmann::ordered_json
statistics(const Reconstruction& reconstruction,
           const std::vector<std::pair<std::string, double>>& stageSeconds);

/// Keys: residual_thickness, share_on_line, tips, lost_tips, webbed_junctions; of a run to the
/// skeleton and beyond also skeleton_length, unexplained_points, nodes.
[[nodiscard]] nlohmann::ordered_json statistics(const ContractionQuality& quality,
                                                bool hasSkeleton);

} // namespace espalier
