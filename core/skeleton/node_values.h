#pragma once

#include "core/skeleton/point_distances.h"
#include "core/skeleton/skeleton.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace espalier {

/// A number that a node can be judged by.
enum class NodeValue : std::uint8_t {
  distance,       // mean distance from its points to its surface [L]; its points are those that its
                  // edge is nearest to
  order,          // branching edges from the root
  radius,         // [L]
  radiusToParent, // its radius as a share of its parent's
  radiusSpread,   // half the width of the interval its radius lies in (RadiusOrigin), as a share of
                  // the radius
  confidence      // how well its radius can be known: the points on its surface as a share of those
             // that would lie there if all of the surface were scanned as the rest is, at most 1
};

/// The value of each node by id; none where it has none: without points, radius or parent.
/// @param distances those of `skeleton`; null: there is no scan, so nothing has a distance
/// @param spacing   between neighboring points of the scan [L]
/// Points scattered evenly at random are a half over the root of their density from the nearest:
/// a full surface has a point per 4 spacing^2. Points farther than 4 spacings lie on nothing.
/// Time O(nodes + points).
[[nodiscard]] std::vector<std::optional<double>> nodeValues(const Skeleton& skeleton,
                                                            NodeValue value,
                                                            const PointDistances* distances,
                                                            double spacing);

} // namespace espalier
