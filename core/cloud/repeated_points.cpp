#include "core/cloud/repeated_points.h"

namespace espalier {

PointSet repeatedPoints(const PointCloud& cloud, const PointSet& leftOut) {
  const Eigen::Matrix3Xf& positions = cloud.positions();
  std::vector<Eigen::Index> repeated;
  Eigen::Index last = -1; // that counts
  const auto look = [&](Eigen::Index point) {
    if (last >= 0 && positions.col(point) == positions.col(last))
      repeated.push_back(point);
    else
      last = point;
  };
  const PointSet kept = PointSet::firstOf(cloud.size()) - leftOut;
  for (const PointSet::Run& run : kept.runs())
    for (std::uint32_t point = run.begin; point < run.end; ++point)
      look(point);
  return PointSet::of(repeated);
}

std::vector<bool> notCounted(const PointCloud& cloud, const PointSet& leftOut) {
  std::vector<bool> result(static_cast<std::size_t>(cloud.size()), false);
  const PointSet passed = leftOut | repeatedPoints(cloud, leftOut);
  for (const Eigen::Index point : (passed & PointSet::firstOf(cloud.size())).points())
    result[static_cast<std::size_t>(point)] = true;
  return result;
}

} // namespace espalier
