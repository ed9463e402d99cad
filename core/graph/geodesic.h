#pragma once

#include "core/graph/neighborhood_graph.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace espalier {

/// Shortest paths along a graph from a set of points to all others.
struct Geodesics {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  std::vector<float> distance;            // [L]; infinite where no path leads
  std::vector<std::uint32_t> predecessor; // next point on the path back; none at a source
};

/// Dijkstra's shortest paths from `sources`.
///
/// @param power  each link costs length^power; > 1 prefers many short links to a leap over a gap.
///               `distance` is the sum of these costs.
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O((N + links) log N).
[[nodiscard]] Geodesics geodesics(const NeighborhoodGraph& graph,
                                  const std::vector<Eigen::Index>& sources, double power = 1,
                                  const Progress& progress = {});

/// Finds the points within a distance along the graph, again and again, without new memory.
/// One per thread.
class GeodesicBall {
public:
  struct Member {
    std::uint32_t point;
    float distance; // [L] along the graph
  };

  explicit GeodesicBall(const NeighborhoodGraph& graph);

  /// The points within `radius` [L] of `center` along the graph, itself first, nearest first.
  /// No more than the `most` nearest. Valid until the next call. Time O(m log m) for m links met.
  const std::vector<Member>& around(Eigen::Index center, float radius,
                                    std::size_t most = std::numeric_limits<std::size_t>::max());

private:
  const NeighborhoodGraph& graph_;
  std::vector<float> distance_; // by point; infinite between calls
  std::vector<Member> heap_;
  std::vector<Member> members_;
  std::vector<std::uint32_t> met_;
};

} // namespace espalier
