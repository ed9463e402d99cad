#pragma once

#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"
#include "core/cloud/point_set.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Geometry>

#include <memory>
#include <vector>

namespace espalier {

/// The points that two plants are of.
struct EvaluatedScan {
  std::shared_ptr<const PointCloud> cloud; // null: there are none
  PointSet leftOut;                        // these do not count

  explicit operator bool() const { return cloud != nullptr && !cloud->isEmpty(); }
};

/// From the frame of a reference to that of the scan: identity, or back to where the result lay,
/// whichever the points are nearer to: a result lies on the scan that it was made of, unless it was
/// moved and the reference was not.
///
/// @param result where it lay before it was registered
/// @param motion by which it is laid on the reference
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] Eigen::Isometry3d toScan(const PointCloud& scan, const Skeleton& result,
                                       const Skeleton& reference, const Eigen::Isometry3d& motion,
                                       const Progress& progress = {});

/// arcCoverages() of a reference that lies on the scan, by id. pre: there are points
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] std::vector<double> seenArcs(const Skeleton& reference, const EvaluatedScan& scan,
                                           const Progress& progress = {});

} // namespace espalier
