#pragma once

#include "core/skeleton/skeleton.h"

#include <cstddef>
#include <vector>

namespace espalier {

/// The Strahler number of each node, by id; 0 where there is no node.
///
/// An apex has 1; a node has the greatest number of its children, and one more if several have
/// that. Time and memory O(N). Source: A. N. Strahler, "Hypsometric analysis of erosional
/// topography", GSA Bulletin 63, 1952.
[[nodiscard]] std::vector<int> strahlerNumbers(const Skeleton& skeleton);

/// The streams of one Strahler number: maximal chains of nodes that have it.
struct StrahlerOrder {
  std::size_t streams = 0;
  double length = 0; // of the edges that lead to their nodes [L]
};

/// The streams of each number, those of 1 first: how the plant branches, whatever its edge types.
/// Empty for an empty skeleton. Time and memory O(N).
[[nodiscard]] std::vector<StrahlerOrder> strahlerOrders(const Skeleton& skeleton);

} // namespace espalier
