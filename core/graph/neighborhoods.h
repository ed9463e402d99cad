#pragma once

#include "core/base/progress.h"
#include "core/graph/neighborhood_graph.h"

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

// All below list the nearest first, are deterministic, use all threads, and throw Cancelled if
// `progress` asks to stop.

/// The `count` nearest others in space; all if there are fewer. Time O(N count log N).
[[nodiscard]] Neighborhoods nearestNeighborhoods(const Eigen::Matrix3Xf& points, int count,
                                                 const Progress& progress = {});

/// Those within `radius` [L] > 0 in space. Time O(N m log m) for m of them.
[[nodiscard]] Neighborhoods neighborhoodsWithin(const Eigen::Matrix3Xf& points, float radius,
                                                const Progress& progress = {});

/// The `count` nearest others along the graph; fewer where the component is smaller.
/// Time O(N m log m) for m links met.
[[nodiscard]] Neighborhoods geodesicNearest(const NeighborhoodGraph& graph, int count,
                                            const Progress& progress = {});

/// Those within `radius` [L] along the graph. Time O(N k m / 16) for m of them; no memory to speak
/// of beside the result.
[[nodiscard]] Neighborhoods geodesicWithin(const NeighborhoodGraph& graph, float radius,
                                           const Progress& progress = {});

} // namespace espalier
