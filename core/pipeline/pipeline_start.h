#pragma once

#include "core/pipeline/pipeline_options.h"

#include <memory>
#include <vector>

namespace espalier {

// What the steps of the pipeline start from.

/// Some columns of a cloud as a cloud about the same origin, without colors.
[[nodiscard]] std::shared_ptr<const PointCloud> someOf(const PointCloud& cloud,
                                                       const std::vector<Eigen::Index>& points);

/// Nothing computed yet: all points where they are, but for those that were set aside, and those at
/// the place of one that was not: each place counts once (core/cloud/repeated_points.h).
[[nodiscard]] PipelineState firstState(const std::shared_ptr<const PointCloud>& cloud,
                                       const PointSet& leftOut);
/// The same with all that these options say of the scan.
[[nodiscard]] PipelineState firstState(const std::shared_ptr<const PointCloud>& cloud,
                                       const PipelineOptions& options);

/// The same once the steps that clean have run; `extent` has the scale for what comes behind.
/// @throws Error if an option of any step is unknown, or one of this step out of range
[[nodiscard]] PipelineState cleanedState(const std::shared_ptr<const PointCloud>& cloud,
                                         const PipelineOptions& options, const PlantScale& scale,
                                         const Progress& progress);

/// The same options once what is no part of the plant is set aside: what steps that clean leave out
/// of the whole scan, other than strays, is in `leftOut`, and these steps are off. For those who
/// run the steps on a part of a scan, where they would find something else.
/// @throws as cleanedState()
[[nodiscard]] PipelineOptions withScanCleaned(const std::shared_ptr<const PointCloud>& cloud,
                                              const PipelineOptions& options,
                                              const Progress& progress);

/// The foot of the plant among the points that cleaning kept: the one nearest to the root that was
/// chosen, or else the one that the points show. 0 if none is left.
/// @param lowest  of the plant (PlantExtent)
[[nodiscard]] Eigen::Index rootPoint(const PipelineState& cleaned, const PipelineOptions& options,
                                     float lowest);

/// @throws Error if the root that was chosen lies farther off than the plant is large
void requireNearRoot(const PointCloud& cloud, const PipelineOptions& options);

} // namespace espalier
