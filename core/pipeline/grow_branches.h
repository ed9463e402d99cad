#pragma once

#include "core/pipeline/attach_grown.h"
#include "core/pipeline/pipeline.h"

#include <memory>
#include <vector>

namespace espalier {

struct GrowOptions {
  PipelineOptions pipeline; // methods, settings and points set aside; its root is not used
  double tolerance = 0;     // [L] as in RegrowOptions; 0 = usualTolerance()
  double widestGap = 0;     // [L] points farther apart are of two parts; 0 = 6 point spacings
  double widestJoin = 0;    // [L] nothing is attached across a wider gap; 0 = as widestGap
};

/// Branches for points that a plant has none for.
///
/// The points fall into parts where gaps are wide; fewer than 5 are dust. Each part is
/// reconstructed by all steps of the pipeline, with the settings that its rules give for the whole
/// scan, from its point that is nearest to the plant; of few points, a line along them. What grew
/// is attached to the plant, and to other parts, where that is near and turns little, or up to 30
/// spacings straight ahead (attached() in attach_grown.h).
///
/// Points that an edge explains are left out, unless hardly any others are among them.
///
/// @param skeleton with radii, in the frame of the file; not empty
/// @param points   columns of `cloud`, ascending
/// @return in order of their nodes; each once. Parts that nothing grows from are left out
/// @throws Error     if nothing grows at all
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(n log n) for n points, and that of the pipeline for them.
[[nodiscard]] std::vector<GrownBranch> grownBranches(const Skeleton& skeleton,
                                                     const std::shared_ptr<const PointCloud>& cloud,
                                                     const std::vector<Eigen::Index>& points,
                                                     const GrowOptions& options = {},
                                                     const Progress& progress = {});

/// The same for all points that no edge explains, but for those set aside. Parts of which less than
/// half and fewer than 20 points stand off the bark, as it is measured (wood_skin.h), grow nothing,
/// nor do points of blades along axes (blades_along.h), and no lines are made of few points, fewer
/// than 20 being dust: whoever chose none does not want each cluster of them.
/// @throws Error also if the plant explains them all
[[nodiscard]] std::vector<GrownBranch>
grownFromUnexplained(const Skeleton& skeleton, const std::shared_ptr<const PointCloud>& cloud,
                     const GrowOptions& options = {}, const Progress& progress = {});

} // namespace espalier
