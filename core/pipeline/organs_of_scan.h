#pragma once

#include "core/pipeline/pipeline_options.h"

#include <memory>
#include <optional>
#include <vector>

namespace espalier {

/// What each point of a scan lies on, as the step Leaves finds it: after the steps before it, which
/// may leave out other things than the plant. Organs that were set by hand are as they were set.
/// @return by point; none: it was set aside or left out, or too few points are left to look at
/// @throws Error     if an option is unknown or out of range
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] std::vector<std::optional<Organ>>
organsOfScan(const std::shared_ptr<const PointCloud>& cloud, const PipelineOptions& options = {},
             const Progress& progress = {});

} // namespace espalier
