#pragma once

#include "core/cloud/point_cloud.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <optional>

namespace espalier {

/// By how much a structure lies off a scan because it is in the frame of the scan's arithmetic
/// mean, as PlantScan3D before 1.4 saved it: what to add to each node [L], the mean of the points.
///
/// None if it fits as it is, or fits in neither frame. Judged by the median distance from a node to
/// the nearest point: it fits as it is if that is at most the spacing of the points; it is shifted
/// if moving it makes that 3 times less, and at most 2 % of the extent of the scan or 3 spacings.
/// None too for fewer than 4 nodes, which may lie near points by chance.
///
/// The same for any unit of both. Deterministic. Time O(N log N) for N points; at most 1000 nodes,
/// spread evenly through the structure, are measured.
[[nodiscard]] std::optional<Eigen::Vector3d> shiftOntoCloud(const Skeleton& skeleton,
                                                            const PointCloud& cloud);

/// What shows that a structure is not one of a scan.
struct Misfit {
  double size = 1;           // extent of the structure over that of the scan
  bool isOfOtherSize = true; // else it is as large, but lies outside of the scan
};

/// Whether a structure is of another plant than a scan, or in another unit: it is over 50 times as
/// small; or over 3 times as large, and most of it is off the points, by the measure above; or the
/// boxes around both do not meet. A part of a plant, or of a scan, is no misfit.
/// None if either is empty or the scan has no extent. Time as above.
[[nodiscard]] std::optional<Misfit> misfitOf(const Skeleton& skeleton, const PointCloud& cloud);

} // namespace espalier
