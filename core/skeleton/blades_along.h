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

/// Of connected points that are off all wood, those that are no blade along an axis, nor half of
/// one. A blade is in one layer with the axis, has no gap to it along most of them, and reaches at
/// least twice as far along it as off it; what of the points is over twice as far off it as it is
/// wide is no blade, as another leaf that touches its margin. Chosen on plants 0 to 41 of
/// scannedPlant() (tests/bench/finding_table.cpp, --found): of herbs with large blades, a fifth as
/// many bare twigs are left, and all that are wood; of bare plants, all.
/// @param spacing between neighboring points [L], > 0
/// @return their places in `points`, ascending: all, where there is no blade
/// Deterministic. Time O(n log n) for n points.
[[nodiscard]] std::vector<std::size_t>
pointsOffBlades(const Skeleton& skeleton, const std::vector<PointOffWood>& points, double spacing);

/// The same of columns of the cloud of `distances`, which are of `skeleton`.
/// @param reach within which of the surface points are not off the wood [L]
/// @return columns, in their order
[[nodiscard]] std::vector<Eigen::Index> pointsOffBlades(const Skeleton& skeleton,
                                                        const std::vector<Eigen::Index>& points,
                                                        const PointDistances& distances,
                                                        double reach, double spacing);

} // namespace espalier
