#pragma once

#include "core/skeleton/check_options.h"
#include "core/skeleton/finding.h"

#include <vector>

namespace espalier {

/// Where wood touches that is not near along the plant; a loop where an axis ends there.
///
/// Two edges touch if their center lines are nearer than the sum of their radii, or than a spacing
/// of the points. About a fork all wood does: places are reported only if the path between them
/// along the plant is longer than `detour` times that sum. One finding for each pair of axes, and
/// for each axis that comes back to itself, where they are deepest in each other: at the end of an
/// axis, if less than twice the sum follows there, else at the node whose edge is later in
/// Skeleton::ids().
/// @param spacing [L]; 0: not known
/// Time O(n log n + p d) for p pairs of near edges and nodes of depth d.
[[nodiscard]] std::vector<Finding> crossings(const Skeleton& skeleton, double spacing,
                                             const CheckOptions& options);

} // namespace espalier
