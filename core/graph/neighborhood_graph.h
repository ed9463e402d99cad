#pragma once

#include "core/base/progress.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace espalier {

/// Links between near points of a cloud. Undirected: each link is listed at both its ends.
///
/// Distances along it follow the plant, where straight ones leap from twig to twig.
class NeighborhoodGraph {
public:
  struct Link {
    std::uint32_t to; // column of the point at the other end
    float length;     // [L]
  };
  using Edge = std::pair<std::uint32_t, std::uint32_t>;

  /// Links each point to its `neighbors` nearest ones; a link holds if either end chose it.
  ///
  /// @param points 3 x N, finite [L]
  /// @param neighbors >= 1; N - 1 if there are fewer points
  /// @throws Cancelled if `progress` asks to stop
  /// Deterministic. Time O(N k log N), memory O(N k).
  NeighborhoodGraph(const Eigen::Matrix3Xf& points, int neighbors, const Progress& progress = {});

  [[nodiscard]] Eigen::Index size() const { return static_cast<Eigen::Index>(begin_.size()) - 1; }
  [[nodiscard]] std::span<const Link> links(Eigen::Index point) const {
    const auto i = static_cast<std::size_t>(point);
    return {links_.data() + begin_[i], links_.data() + begin_[i + 1]};
  }

  /// This graph with more links. pre: none of `edges` is there yet
  [[nodiscard]] NeighborhoodGraph withLinks(const std::vector<Edge>& edges,
                                            const Eigen::Matrix3Xf& points) const;

private:
  NeighborhoodGraph() = default;

  std::vector<std::size_t> begin_; // N + 1 places in links_
  std::vector<Link> links_;
};

} // namespace espalier
