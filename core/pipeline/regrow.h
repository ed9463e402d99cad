#pragma once

#include "core/pipeline/pipeline.h"

#include <memory>

namespace espalier {

struct RegrowOptions {
  PipelineOptions pipeline; // methods and settings; its root is not used
  double tolerance = 0;     // [L] that edges explain points around them (barkReaches());
                            // 0 = usualTolerance()
  double widestGap = 0;     // [L] points farther off are another part; 0 = 8 point spacings
};

/// What a node carries, reconstructed again from the points that the rest of the plant leaves.
///
/// These are the points nearest to an edge of what it carries now, and those that no edge explains
/// (freePoints()), as far as they are connected with the points at the node. Where that stands, its
/// edge explains no more than the tolerance: there the branch begins. All steps of the pipeline run
/// on them, with the settings that its rules give for the whole scan, so that what grows looks like
/// the rest; or branches are traced along them, where that follows them as well, with edges as long
/// as there were: in place of unbranched nodes also from the node on, where their ends lie before
/// and behind it. No new node is thicker than `node`, if that has a radius, and none turns back
/// sharply.
///
/// @param skeleton with radii, in the frame of the file; contains `node`
/// @return one tree: its root stands for `node`, at its place; the others are new
///         (core/skeleton/branch_edits.h puts them into the skeleton)
/// @throws Error     if no such points are near the node, nothing grows from them, or it follows
///                   them worse than the unbranched nodes that are there now
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N log n), and that of the pipeline for the points found.
[[nodiscard]] Skeleton regrown(const Skeleton& skeleton, NodeId node,
                               const std::shared_ptr<const PointCloud>& cloud,
                               const RegrowOptions& options = {}, const Progress& progress = {});

} // namespace espalier
