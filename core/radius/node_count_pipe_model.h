#pragma once

#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier {

/// Number of nodes that each node carries, itself included, by id. Time O(n).
[[nodiscard]] std::vector<double> carriedNodes(const Skeleton& skeleton);

struct NodeCountPipeOptions {
  double rootRadius = 0; // [L], >= apexRadius
  double apexRadius = 0; // [L], >= 0; 0: no radius is known, and all stay so
};

/// `skeleton` with radii that follow what each node carries: r(v) = apex * n(v)^e, where n(v) is
/// the number of nodes that v carries, itself included, and e makes the heaviest root as thick as
/// asked.
///
/// The radii of the published structures of the thesis follow this law, with 1/e near 3.
/// It counts nodes, so it asks for even node spacing. Time O(n).
[[nodiscard]] Skeleton withNodeCountPipeRadii(const Skeleton& skeleton,
                                              const NodeCountPipeOptions& options);

} // namespace espalier
