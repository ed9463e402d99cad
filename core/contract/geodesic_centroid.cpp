#include "core/contract/geodesic_centroid.h"

#include "core/contract/ball_centers.h"

namespace espalier {

Eigen::Matrix3Xf contractedToGeodesicCentroids(const Eigen::Matrix3Xf& points,
                                               const GeodesicCentroidOptions& options,
                                               const Progress& progress) {
  if (points.cols() < 2) return points;
  const NeighborhoodGraph graph(points, options.neighbors, progress.part(0, 0.4));
  Eigen::Matrix3Xf result(3, points.cols());
  const GeodesicBalls::Lanes radii =
      GeodesicBalls::Lanes::Constant(static_cast<float>(options.radius));
  const auto contract = [&](const GeodesicBalls& balls) {
    putCenters(balls, points, radii, options.fitsCircles, result);
  };
  forEachGeodesicBalls(
      graph, [&](std::uint32_t /*center*/) { return options.radius; }, contract,
      progress.part(0.4, 1));
  return result;
}

} // namespace espalier
