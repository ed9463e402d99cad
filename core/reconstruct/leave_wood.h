#pragma once

#include "core/reconstruct/trace.h"
#include "core/skeleton/edge_index.h"
#include "core/skeleton/skeleton_delta.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace espalier {

/// Where places that begin on the wood of a plant leave it.
struct Leaving {
  std::size_t first;     // of the places that are off it
  TraceBegin begin;      // what bears them
  Eigen::Vector3d place; // there [L]
};

/// Finds the first of some places that are off the wood on which they begin, and where that bears
/// them: where their course, led back, comes nearest to the middle of the wood; at a node, if one
/// is within 2 spacings.
///
/// @param places   in order [L], some spacings apart at most
/// @param spacing  of the points [L], > 0
/// @return none if they do not begin within a spacing of the wood, or do not leave it
/// Deterministic. Time O(places log N).
[[nodiscard]] std::optional<Leaving> leavingWood(const std::vector<Eigen::Vector3d>& places,
                                                 const EdgeIndex& wood, double spacing);

/// Adds a branch along a trace that begins on the plant: a new node there, if that is on an edge,
/// and one for each place but the first. @return the last of these nodes, or the one that bears the
/// branch, if there are none. pre: trace.begin
NodeId addTrace(SkeletonEditor& editor, const Trace& trace);

} // namespace espalier
