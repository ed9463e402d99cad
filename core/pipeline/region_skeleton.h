#pragma once

#include "core/cloud/ball.h"
#include "core/pipeline/pipeline_options.h"

#include <vector>

namespace espalier {

/// What the skeleton of a part of a scan would be: all steps after the contraction and before the
/// radii, run on each connected part of it.
///
/// @param region          contracted, none of its points left out; its scale is of the whole
/// @param distanceToRoot  by point of it, along the plant [L]
/// @param ball            what lies outside of it is cut off
/// @throws Error     if no part can be reconstructed, and one fails
/// @throws Cancelled if `progress` asks to stop
/// See RegionPreviewer::reconstructed().
[[nodiscard]] Skeleton skeletonOfRegion(const PipelineState& region,
                                        const std::vector<float>& distanceToRoot, const Ball& ball,
                                        const PipelineOptions& options,
                                        const Progress& progress = {});

} // namespace espalier
