#pragma once

#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"
#include "core/cloud/point_set.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <functional>
#include <vector>

namespace espalier {

/// The few points that lie far from all others, as one at 0 0 0 does in a scan in UTM coordinates.
///
/// The size of the scan is here the largest side of the box that holds its points but for the least
/// and greatest sixteenth along each axis: up to 5 % of strays, however far, hardly change it.
/// Points are far if they lie more than this size outside of that box, at least half of it away
/// from all others (always so if that is 1.75 sizes), and are no more than 1 % of all together.
/// Nothing is far if in sum that would be more than a sixteenth of the points: these are no few.
///
/// @param count   of points
/// @param place   of a point [L]
/// @param bounds  of all of them [L]
/// @return ascending
/// Time O(1) if the bounds are not larger than three times that box; else O(count).
[[nodiscard]] std::vector<Eigen::Index>
farPoints(Eigen::Index count, const std::function<Eigen::Vector3d(Eigen::Index)>& place,
          const Eigen::AlignedBox3d& bounds);

/// The same of a cloud, among the points that count: those of `leftOut` are none of it, and each
/// place counts once. Mostly it has none. @return with each point those repeated at its place.
/// O(N).
/// @throws Cancelled if `progress` asks to stop, which it is asked alone
[[nodiscard]] std::vector<Eigen::Index>
farPoints(const PointCloud& cloud, const PointSet& leftOut = {}, const Progress& progress = {});
/// The same, where it is known which points do not count (notCounted()); none of these.
[[nodiscard]] std::vector<Eigen::Index> farPoints(const PointCloud& cloud,
                                                  const std::vector<bool>& isNotCounted);

/// Bounds of a cloud but for its far points and those of `leftOut` [L], frame of the file; empty
/// without points. O(N).
/// @throws Cancelled if `progress` asks to stop, which it is asked alone
[[nodiscard]] Eigen::AlignedBox3d plantBounds(const PointCloud& cloud, const PointSet& leftOut = {},
                                              const Progress& progress = {});

} // namespace espalier
