#pragma once

#include "core/doubt/doubt.h"
#include "core/doubt/doubt_sources.h"

#include <vector>

namespace espalier {

/// Where it is not sure how a plant is, what would put most of it right first: ends that may be no
/// shoots, branches that may grow from other wood, and points that may be a branch. What was
/// reviewed, and what is sure by 95 %, is not in doubt.
///
/// Uses all threads, deterministic. Time O(N log N), and that of a trace for each cluster of points
/// without wood.
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] std::vector<Doubt> findDoubts(const Skeleton& skeleton, const DoubtSources& sources,
                                            const Progress& progress = {});

} // namespace espalier
