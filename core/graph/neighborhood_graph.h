#pragma once

#include "core/base/progress.h"
#include "core/graph/neighborhoods.h"

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace espalier {

/// Which points are linked.
enum class LinkKind : std::uint8_t {
  nearest, // the nearest ones
  angles,  // the nearest that leave no gap of over 90 degrees around a point, where there are any
  voronoi  // those whose Voronoi cells touch in the tangent plane
};

/// How each point of a cloud is linked to others. The last two kinds choose of the 3 `count`
/// nearest, and link the lines in which a scanner sampled a surface
/// (core/graph/tangent_neighbors.h).
struct PointLinks {
  // NOLINTNEXTLINE(google-explicit-constructor): a number is links to that many nearest points
  constexpr PointLinks(int links = 7, LinkKind how = LinkKind::nearest) : count(links), kind(how) {}
  bool operator==(const PointLinks&) const = default;

  int count; // >= 1; not looked at by Voronoi but for the candidates
  LinkKind kind;
};

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

  /// Links each point to near ones; a link holds if either end chose it.
  ///
  /// @param points 3 x N, finite [L]
  /// @param links to N - 1 others if there are fewer points
  /// @throws Cancelled if `progress` asks to stop
  /// Deterministic. Time O(N k log N), memory O(N k).
  NeighborhoodGraph(const Eigen::Matrix3Xf& points, const PointLinks& links,
                    const Progress& progress = {});

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
  void linkNearest(const Eigen::Matrix3Xf& points, int neighbors, const Progress& progress);
  void linkChosen(const Eigen::Matrix3Xf& points, const Neighborhoods& chosen);

  std::vector<std::size_t> begin_; // N + 1 places in links_
  std::vector<Link> links_;
};

} // namespace espalier
