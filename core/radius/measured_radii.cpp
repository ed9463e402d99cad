#include "core/radius/measured_radii.h"

#include "core/skeleton/assign_points.h"

namespace espalier {

std::vector<double> meanPointDistances(const Skeleton& skeleton, const Eigen::Matrix3Xf& points,
                                       const Eigen::Vector3d& origin, const Progress& progress) {
  std::vector<double> sums(skeleton.idEnd(), 0);
  if (skeleton.isEmpty()) return sums;
  std::vector<double> counts(skeleton.idEnd(), 0);
  for (const PointOnSkeleton& place : assignPoints(points, origin, skeleton, 8, progress)) {
    const bool isLower = place.fraction < 0.5 && skeleton[place.child].parent;
    const NodeId node = isLower ? *skeleton[place.child].parent : place.child;
    sums[indexOf(node)] += place.distance;
    counts[indexOf(node)] += 1;
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (counts[i] > 0) sums[i] /= counts[i];
  return sums;
}

} // namespace espalier
