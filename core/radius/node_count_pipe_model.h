#pragma once

#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier {

struct NodeCountPipeOptions {
  double rootRadius = 0; // [L], >= apexRadius
  double apexRadius = 0; // [L], > 0
};

/// `skeleton` with radii that follow what each node carries: r(v) = apex * n(v)^e, where n(v) is
/// the number of nodes that v carries, itself included, and e makes the heaviest root as thick as
/// asked.
///
/// The radii of the published structures of the thesis follow this law, with 1/e near 3.
/// It counts nodes, so it asks for even node spacing. Time O(n).
[[nodiscard]] Skeleton withNodeCountPipeRadii(const Skeleton& skeleton,
                                              const NodeCountPipeOptions& options);

/// The ends of the pipe model from what was measured: the median over the tips, and, for the root,
/// what the median of the exponents leads to that go through the tips and through each of the nodes
/// that carry at least half of the heaviest tree.
///
/// @param measured [L] by id, 0 where nothing was measured
/// @return the apex radius is at most the root radius; both are the mean measured radius, or 1,
///         where there is nothing to take a median of
[[nodiscard]] NodeCountPipeOptions pipeEndRadii(const Skeleton& skeleton,
                                                const std::vector<double>& measured);

} // namespace espalier
