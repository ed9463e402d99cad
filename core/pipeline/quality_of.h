#pragma once

#include "core/evaluate/study/contraction_quality.h"
#include "core/pipeline/pipeline.h"

namespace espalier {

/// How good the contraction of a run is, and its skeleton, if it has one.
///
/// Points that were set aside do not count; ends are sought from the root that was chosen, or else
/// the one that the points show. @throws Cancelled if `progress` asks to stop
[[nodiscard]] ContractionQuality qualityOf(const PointCloud& cloud, const Reconstruction& result,
                                           const PipelineOptions& options,
                                           const Progress& progress = {});

} // namespace espalier
