#include "core/evaluate/scan_sight.h"

#include "core/radius/arc_coverage.h"
#include "core/skeleton/edge_index.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace espalier {
namespace {

/// Mean distance of about a thousand points, evenly chosen, from a skeleton [L].
double distanceOf(const PointCloud& scan, const Skeleton& skeleton, const Progress& progress) {
  const EdgeIndex index(skeleton);
  const Eigen::Index step = std::max<Eigen::Index>(1, scan.size() / 1000);
  double sum = 0;
  Eigen::Index count = 0;
  for (Eigen::Index point = 0; point < scan.size(); point += step, ++count) {
    progress.check();
    const auto nearest = index.nearest(scan.position(point));
    sum += (nearest->position - scan.position(point)).norm();
  }
  return sum / static_cast<double>(std::max<Eigen::Index>(1, count));
}

} // namespace

Eigen::Isometry3d toScan(const PointCloud& scan, const Skeleton& result, const Skeleton& reference,
                         const Eigen::Isometry3d& motion, const Progress& progress) {
  if (scan.isEmpty()) return Eigen::Isometry3d::Identity();
  const bool isOnResult =
      distanceOf(scan, result, progress) < distanceOf(scan, reference, progress);
  return isOnResult ? motion.inverse() : Eigen::Isometry3d::Identity();
}

std::vector<double> seenArcs(const Skeleton& reference, const EvaluatedScan& scan,
                             const Progress& progress) {
  assert(scan);
  const PointCloud& cloud = *scan.cloud;
  SpatialIndex index(cloud.positions(), progress);
  const double spacing = pointSpacing(cloud.positions(), index); // those passed over count, too
  if (!scan.leftOut.isEmpty()) {
    std::vector<bool> isPassed(static_cast<std::size_t>(cloud.size()), false);
    for (const Eigen::Index point : scan.leftOut.points())
      if (point < cloud.size()) isPassed[static_cast<std::size_t>(point)] = true;
    index = index.passingOver(std::move(isPassed));
  }
  return arcCoverages(reference, {cloud.positions(), cloud.origin(), index, spacing}, progress);
}

} // namespace espalier
