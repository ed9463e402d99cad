#pragma once

#include "core/skeleton/skeleton.h"

namespace espalier {

/// `skeleton` with nodes left out where its axes are straight, so that there are many where they
/// bend: no node left out is farther than `tolerance` from the straight line between those that
/// stay.
///
/// Roots, tips, branching nodes, and nodes that carry units of an MTG or marks stay; what is
/// attached to what, and where axes begin, is the same.
/// @param tolerance [L], >= 0
/// Time O(n log n) as a rule. Source: D. Douglas, T. Peucker, Cartographica 10, 1973.
[[nodiscard]] Skeleton withSimpleAxes(const Skeleton& skeleton, double tolerance);

} // namespace espalier
