#include "core/contract/geodesic_centroid.h"

#include "core/base/parallel.h"
#include "core/graph/geodesic.h"

#include <oneapi/tbb/enumerable_thread_specific.h>

namespace espalier {

Eigen::Matrix3Xf contractedToGeodesicCentroids(const Eigen::Matrix3Xf& points,
                                               const GeodesicCentroidOptions& options,
                                               const Progress& progress) {
  if (points.cols() < 2) return points;
  const NeighborhoodGraph graph(points, options.neighbors, progress.part(0, 0.15));
  oneapi::tbb::enumerable_thread_specific<GeodesicBall> balls([&] { return GeodesicBall(graph); });
  Eigen::Matrix3Xf result(3, points.cols());
  const auto contract = [&](Eigen::Index point) {
    const auto& members = balls.local().around(point, static_cast<float>(options.radius));
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const GeodesicBall::Member& member : members)
      sum += points.col(member.point).cast<double>();
    result.col(point) = (sum / static_cast<double>(members.size())).cast<float>();
  };
  parallelFor(points.cols(), contract, progress.part(0.15, 1), 32);
  return result;
}

} // namespace espalier
