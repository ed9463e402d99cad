#pragma once

#include "core/evaluate/differences/differences.h"
#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier {

/// A skeleton with what it lacks of another, to be drawn as one.
struct WithMissed {
  Skeleton skeleton;             // the result under its own ids, and missed stretches behind it
  std::vector<Difference> kinds; // by id
};

/// Adds to `result` the edges of `reference` that are missed, each connected stretch from where it
/// begins, on the node that would bear it; as a tree of its own where there is none. O(N log N).
/// @param found  differences(result, reference, …)
[[nodiscard]] WithMissed withMissed(const Skeleton& result, const Skeleton& reference,
                                    const Differences& found);

} // namespace espalier
