#pragma once

#include "core/skeleton/skeleton_delta.h"

#include <vector>

namespace espalier {

// Edits of many nodes along a path at once. A path leads along edges (pathBetween, pathOf), and
// its two ends stay as they are. Each leaves a valid forest with at most one successor more per
// node than it found, and is refused before it changes anything. pre, of all: the nodes are
// contained.

/// Length of an edge, as a mean of all [L]; 0 without edges. Time O(nodes).
[[nodiscard]] double meanEdgeLength(const Skeleton& skeleton);

/// Puts the nodes of a path on the straight line between its ends, at the shares of its length that
/// they were at. What they carry stays.
/// @throws Error if there is no node between the ends
void straighten(SkeletonEditor& editor, const std::vector<NodeId>& path);

/// Gives the nodes of a path radii between those of its ends, by the length along it.
/// @throws Error if there is no node between the ends, or an end has no radius
void interpolateRadii(SkeletonEditor& editor, const std::vector<NodeId>& path);

/// Removes the nodes between the ends that only continue an axis: branching nodes, those that units
/// of an MTG start at, and marked ones stay, so what is attached to what is the same.
/// @throws Error if there is none
void thinOut(SkeletonEditor& editor, const std::vector<NodeId>& path);

/// Moves each of the nodes to the mean of its neighbors along its axis, weighted by a Gaussian of
/// their distance along it, the node itself included. The ends of axes stay.
///
/// As many neighbors count before as behind, so even nodes of a straight axis stay, and ends do not
/// shrink. All are moved from where they were before. Time O(nodes of the skeleton).
/// @param width  standard deviation of the Gaussian [L], > 0; edges much longer are not smoothed
/// Source: PlantScan3D's "Smooth" weights parent and children alike, and shrinks tips.
void smooth(SkeletonEditor& editor, const std::vector<NodeId>& nodes, double width);

/// Spaces nodes evenly: along each stretch, nodes are moved, removed or added so that edges are as
/// near to `step` as their number allows. Radii are interpolated.
///
/// A stretch runs between nodes that stay: branching nodes, tips, roots, starts of units, marked
/// nodes, and those whose neighbors along the axis are not among `nodes`. New nodes join the units
/// of the stretch as those of splitEdge() do.
/// @param step  wanted length of edges [L], > 0
/// @throws Error if there would be over a million new nodes
void resample(SkeletonEditor& editor, const std::vector<NodeId>& nodes, double step);

} // namespace espalier
