#pragma once

#include "core/cloud/point_cloud.h"
#include "core/skeleton/skeleton.h"

#include <vector>

namespace espalier::test {

/// How nodes that were added to a plant follow the points of its scan.
struct Course {
  double sharpestTurn = 0;   // [degrees], from the edge below to one of theirs
  double farthestNode = 0;   // [L] from the nearest point, beyond the radius
  double farthestOnEdge = 0; // likewise, of places on their edges
  std::size_t nodes = 0;
};

/// @param added  nodes of the plant, with the edges to their parents
[[nodiscard]] Course courseOf(const Skeleton& plant, const std::vector<NodeId>& added,
                              const PointCloud& cloud);

} // namespace espalier::test
