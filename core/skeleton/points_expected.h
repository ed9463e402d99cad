#pragma once

#include "core/skeleton/point_distances.h"

#include <vector>

namespace espalier {

/// How many points a scan has of wood of some thickness: what is hidden, or so thin that beams miss
/// it, has few everywhere.
///
/// Of the other edges in order of their radii, those next to an edge that together are a quarter as
/// long as all others say how many points there are along it.
class PointsExpected {
public:
  /// @param reach [L]: farther from the wood, points are not of it
  /// Time O(n log n + N).
  PointsExpected(const Skeleton& skeleton, const PointDistances& distances, double reach);

  /// Along the thickest of some edges, by edges that are none of them [1 / L]. 0: there are none.
  /// Time O(n).
  [[nodiscard]] double perLength(const std::vector<NodeId>& edges) const;

private:
  struct Edge {
    NodeId node;
    double length;
    double points;
  };
  std::vector<Edge> edges_;        // by radius
  std::vector<std::size_t> place_; // there, by id
  double length_ = 0;              // of all
};

} // namespace espalier
