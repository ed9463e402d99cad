#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace espalier {

/// A longest common subsequence: places in `a` and in `b` that hold the same, in order. None if
/// they differ by more than `mostDifferences` places.
///
/// Source: E. W. Myers, "An O(ND) difference algorithm and its variations", Algorithmica 1, 1986.
/// Time O((size of both) times differences), memory O(differences squared).
[[nodiscard]] std::optional<std::vector<std::pair<std::size_t, std::size_t>>>
matchSequences(const std::vector<int>& a, const std::vector<int>& b, std::size_t mostDifferences);

} // namespace espalier
