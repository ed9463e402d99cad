#pragma once

#include "core/skeleton/skeleton_delta.h"

#include <utility>
#include <vector>

namespace espalier {

// Edits of radii, as steps of the history. None of them moves a node. pre, of all: the nodes given
// are contained. A radius of 0 is one that is not known.

/// Moves each radius halfway to what its neighbors on the axis give for its place.
///
/// Between two neighbors the radius is read off a straight line, so an even slope stays as it is,
/// however the nodes are spaced. The ends of axes and unknown radii stay. All are read from before.
/// Source: after PlantScan3D's "Average radius", which flattens slopes and mixes axes.
void smoothRadii(SkeletonEditor& editor, const std::vector<NodeId>& nodes);

/// Makes no radius greater than that of the nearest node below it whose radius is known; from the
/// root up, so that limits pass on. Time O(nodes of the skeleton).
/// Source: PlantScan3D's "Filter radius".
void limitRadii(SkeletonEditor& editor, const std::vector<NodeId>& nodes);

/// Gives all that `from` carries the radii of a node-count pipe model that begins with the radius
/// of `from` (node_count_pipe_model.h).
///
/// The tips get the median radius of those of them that have one; if none has, the exponent is 1/3,
/// that of the published structures. Tips are at most as thick as `from`.
///
/// @param kept  nodes that keep the radius that they have: the pipe begins anew at each of them
/// @throws Error if `from` has no radius or carries nothing
/// Time O(nodes of the skeleton).
void pipeModelFrom(SkeletonEditor& editor, NodeId from, const std::vector<NodeId>& kept = {});

/// The nodes whose radius is within `share` of the measured one.
/// @param measured [L], of nodes that are contained; as SectionRadii::radii
[[nodiscard]] std::vector<NodeId>
confirmedNodes(const Skeleton& skeleton, const std::vector<std::pair<NodeId, double>>& measured,
               double share = 0.15);

} // namespace espalier
