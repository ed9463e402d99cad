#pragma once

#include "core/pipeline/pipeline.h"

#include <memory>
#include <vector>

namespace espalier {

struct GrowOptions {
  PipelineOptions pipeline; // methods, settings and points set aside; its root is not used
  double tolerance = 0;     // [L] as in RegrowOptions; 0 = 3 point spacings
  double widestGap = 0;     // [L] points farther apart are of two parts; 0 = 8 point spacings
  double widestJoin = 0;    // [L] a part farther off is not of this plant; 0 = a tenth of the
                            // height of the scan
};

/// A new tree to be hung on a node: its root stands for that (addCarried in branch_edits.h).
struct GrownBranch {
  NodeId on;
  Skeleton part;
};

/// Branches for points that a plant has none for.
///
/// The points fall into parts where gaps are wide; fewer than 20 are dust. Each part is
/// reconstructed by all steps of the pipeline, with the settings that its rules give for the whole
/// scan, from its point that is nearest to the plant, and hangs on the node whose wood is nearest
/// to that, or on the next one if it would begin backward; none of it is thicker than the node, if
/// that has a radius. A part that is nearer to another part than to the plant hangs on that one.
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

/// The same for all points that no edge explains, but for those set aside. Parts that lie nowhere
/// farther than twice the tolerance from the wood are rough bark, and grow nothing.
/// @throws Error also if the plant explains them all
[[nodiscard]] std::vector<GrownBranch>
grownFromUnexplained(const Skeleton& skeleton, const std::shared_ptr<const PointCloud>& cloud,
                     const GrowOptions& options = {}, const Progress& progress = {});

} // namespace espalier
