#pragma once

#include "core/skeleton/point_distances.h"

#include <vector>

namespace espalier {

/// How many points a scan has of wood of some thickness: what is hidden, or so thin that beams miss
/// it, has few everywhere.
///
/// Of the edges in order of their radii, those about an edge that together are a quarter as long as
/// all say how many points there are along it.
class PointsExpected {
public:
  /// @param reach [L]: farther from the wood, points are not of it
  /// Time O(n log n + N).
  PointsExpected(const Skeleton& skeleton, const PointDistances& distances, double reach);

  [[nodiscard]] double perLength(NodeId id) const { return perLength_[indexOf(id)]; } // [1 / L]

private:
  std::vector<double> perLength_; // by id
};

} // namespace espalier
