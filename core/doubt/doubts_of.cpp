#include "core/doubt/doubts_of.h"

#include "core/cloud/point_set.h"
#include "core/doubt/find_doubts.h"
#include "core/graph/turn_upright.h"

namespace espalier {

std::shared_ptr<const PointCloud> pointsOf(const std::shared_ptr<const PointCloud>& cloud,
                                           const Reconstruction& result) {
  return result.apart ? std::make_shared<const PointCloud>(without(*cloud, *result.apart)) : cloud;
}

RatedDoubts doubtsOf(const std::shared_ptr<const PointCloud>& cloud, const Reconstruction& result,
                     UpAxis up, const Progress& progress) {
  const Skeleton& skeleton = *result.skeleton;
  if (skeleton.size() < 2 || !(result.scale.spacing > 0)) return {};
  const auto points = pointsOf(cloud, result);
  const SpatialIndex index(points->positions(), progress);
  const PointDistances distances(points, result.scale.spacing, skeleton, progress.part(0, 0.2));
  const Eigen::Vector3d upward = turnUpright(up).row(2).transpose();
  return {
      .doubts = findDoubts(
          skeleton, {.distances = distances, .index = index, .scale = result.scale, .up = upward},
          progress.part(0.2, 0.6)),
      .ratings =
          errorRatings(skeleton, distances, index, result.scale, upward, progress.part(0.6, 1))};
}

} // namespace espalier
