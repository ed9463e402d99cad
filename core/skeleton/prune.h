#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"
#include "core/skeleton/skeleton.h"

namespace espalier {

struct SpurOptions {
  Length length = spacings(7.25) + thicknesses(1.5); // [L] spurs shorter than this go
  double radiusShare =
      0; // and those shorter than length + radiusShare * radius at their foot, >= 0
};

/// `skeleton` without its spurs: the short unbranched ends that bumps of the bark and stray points
/// leave on it. Shortest first; when one is gone, what it sat on may be longer than it seemed, and
/// stay.
///
/// The foot of a spur is the branching node that bears it; its length runs from there to its tip.
/// An unbranched plant is never pruned, and the longest end of each branching stays.
/// Time O(n log n).
[[nodiscard]] Skeleton withoutSpurs(const Skeleton& skeleton, const SpurOptions& options,
                                    const Progress& progress = {});

} // namespace espalier
