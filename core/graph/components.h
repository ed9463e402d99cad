#pragma once

#include "core/graph/neighborhood_graph.h"

#include <limits>
#include <vector>

namespace espalier {

/// The connected parts of a graph.
struct Components {
  std::vector<std::uint32_t> ofPoint; // number of the component each point is in
  std::vector<Eigen::Index> sizes;    // points in each, largest first

  [[nodiscard]] std::size_t count() const { return sizes.size(); }
};

/// Numbers the connected components, the largest first; of equal ones, that of the first point.
/// Time and memory O(N + links).
[[nodiscard]] Components connectedComponents(const NeighborhoodGraph& graph);

/// The points that links of at most `longest` [L] lead to from `first`, itself among them,
/// ascending: the nearest neighbors of points that stand alone are far off.
/// @param isMet  by point; those met before are not gone to, those of the result are marked
/// Time O(links of the result).
[[nodiscard]] std::vector<Eigen::Index> pointsLinkedTo(const NeighborhoodGraph& graph,
                                                       Eigen::Index first, float longest,
                                                       std::vector<bool>& isMet);

/// `graph` made connected by the shortest possible bridges (those of a minimum spanning tree of the
/// gaps between its components), but for gaps wider than `widestGap` [L].
///
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O((N - largest component) log N) per round, at most log(components) rounds.
[[nodiscard]] NeighborhoodGraph joined(const NeighborhoodGraph& graph,
                                       const Eigen::Matrix3Xf& points,
                                       float widestGap = std::numeric_limits<float>::max(),
                                       const Progress& progress = {});

} // namespace espalier
