#include "core/align/scan_distances.h"

#include "core/base/parallel.h"

#include <limits>

namespace espalier {

std::vector<float> distancesToScan(const PointCloud& moved, const Eigen::Isometry3d& motion,
                                   const PointCloud& fixed, const SpatialIndex& index,
                                   const Progress& progress) {
  std::vector<float> distances(static_cast<std::size_t>(moved.size()),
                               std::numeric_limits<float>::quiet_NaN());
  parallelFor(
      moved.size(),
      [&](Eigen::Index i) {
        const Eigen::Vector3f place = (motion * moved.position(i) - fixed.origin()).cast<float>();
        if (const auto nearest = index.nearestOne(place))
          distances[static_cast<std::size_t>(i)] =
              (fixed.positions().col(nearest->index) - place).norm();
      },
      progress);
  return distances;
}

} // namespace espalier
