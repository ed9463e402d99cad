#pragma once

#include <cstdint>
#include <vector>

namespace espalier {

/// A link that may be taken in one direction only.
struct DirectedLink {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  double cost = 0;
};

/// The rooted tree over all places whose links cost least in all.
///
/// Unlike shortest paths, each place is attached where its own link is cheap, however long the path
/// is from there to the root; unlike a greedy choice, no cycle is left over.
///
/// @param count  of places, >= 1
/// @param links  finite costs; of equal ones the first goes
/// @return for each place the link that leads to it; -1 for the root and for places that no path
///         leads to
/// Deterministic. Time O(links log count).
/// Source: R. E. Tarjan, "Finding optimum branchings", Networks 7, 1977, with the mergeable heaps
/// of H. N. Gabow et al., Combinatorica 6, 1986.
[[nodiscard]] std::vector<int> minimumArborescence(std::uint32_t count, std::uint32_t root,
                                                   const std::vector<DirectedLink>& links);

} // namespace espalier
