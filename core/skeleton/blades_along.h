#pragma once

#include "core/skeleton/point_distances.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// A point that is off all wood.
struct PointOffWood {
  Eigen::Vector3d place; // [L], frame of the file
  NodeId edge;           // that is nearest
  double off;            // [L], from where points are off the wood
};

/// @param points columns of the cloud of `distances`
/// @param reach  within which of the surface they are not off the wood [L]
[[nodiscard]] std::vector<PointOffWood> pointsOffWood(const std::vector<Eigen::Index>& points,
                                                      const PointDistances& distances,
                                                      double reach);

/// Whether connected points that are off all wood are a blade along an axis, or half of one, rather
/// than a branch: in one layer with the axis, with no gap to it along most of them, and at least
/// twice as far along it as off it. Chosen on plants 0 to 41 of scannedPlant() (tests/bench/
/// finding_table.cpp, --found): of herbs with large blades, a fifth as many bare twigs are left,
/// and all that are wood; of bare plants, all.
/// @param points  not empty
/// @param spacing between neighboring points [L], > 0
/// Deterministic. Time O(n log n) for n points.
[[nodiscard]] bool isBladeAlong(const Skeleton& skeleton, const std::vector<PointOffWood>& points,
                                double spacing);

} // namespace espalier
