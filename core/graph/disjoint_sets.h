#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace espalier {

/// Disjoint sets of 0 ... count - 1.
class DisjointSets {
public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  std::uint32_t find(std::uint32_t of) {
    while (parent_[of] != of)
      of = parent_[of] = parent_[parent_[of]];
    return of;
  }
  /// The smaller number of the two stands for both. @returns whether they were apart
  bool join(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax({find(a), find(b)});
    parent_[high] = low;
    return low != high;
  }

private:
  std::vector<std::uint32_t> parent_;
};

} // namespace espalier
