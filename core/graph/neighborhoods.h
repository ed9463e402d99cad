#pragma once

#include "core/base/progress.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace espalier {

/// For each point of a cloud those that count as its neighbors, itself not among them.
struct Neighborhoods {
  std::vector<std::size_t> begin, end; // by point: places in members
  std::vector<std::uint32_t> members;  // columns of the cloud

  [[nodiscard]] std::size_t size() const { return begin.size(); }
  [[nodiscard]] std::span<const std::uint32_t> of(Eigen::Index point) const {
    const auto i = static_cast<std::size_t>(point);
    return {members.data() + begin[i], members.data() + end[i]};
  }
};

/// One list of neighbors per point, joined. @throws Cancelled if `progress` asks to stop
[[nodiscard]] Neighborhoods joinedLists(const std::vector<std::vector<std::uint32_t>>& lists,
                                        const Progress& progress = {});

/// The `count` nearest others in space, the nearest first; all if there are fewer. Deterministic,
/// uses all threads. Time O(N count log N). @throws Cancelled if `progress` asks to stop
[[nodiscard]] Neighborhoods nearestNeighborhoods(const Eigen::Matrix3Xf& points, int count,
                                                 const Progress& progress = {});

} // namespace espalier
