#pragma once

#include "core/skeleton/skeleton.h"

namespace espalier {

/// `skeleton` with each node moved by `share` of the distance to the mean of its neighbors on its
/// axis, all at once, `rounds` times. Where an axis begins and ends it stays.
/// @param share in [0, 1]; @param rounds >= 0
/// Time O(n rounds).
[[nodiscard]] Skeleton withSmoothAxes(const Skeleton& skeleton, double share, int rounds = 1);

} // namespace espalier
