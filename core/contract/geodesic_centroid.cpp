#include "core/contract/geodesic_centroid.h"

#include "core/graph/geodesic_balls.h"

#include <array>

namespace espalier {

Eigen::Matrix3Xf contractedToGeodesicCentroids(const Eigen::Matrix3Xf& points,
                                               const GeodesicCentroidOptions& options,
                                               const Progress& progress) {
  if (points.cols() < 2) return points;
  const NeighborhoodGraph graph(points, options.neighbors, progress.part(0, 0.4));
  Eigen::Matrix3Xf result(3, points.cols());
  const auto contract = [&](const GeodesicBalls& balls) {
    std::array<Eigen::Vector3d, GeodesicBalls::most> sums;
    sums.fill(Eigen::Vector3d::Zero());
    std::array<int, GeodesicBalls::most> counts{};
    balls.forEachMember([&](std::size_t center, std::uint32_t point, float /*distance*/) {
      sums[center] += points.col(point).cast<double>();
      ++counts[center];
    });
    for (std::size_t i = 0; i < balls.centers().size(); ++i)
      result.col(balls.centers()[i]) = (sums[i] / counts[i]).cast<float>();
  };
  forEachGeodesicBalls(
      graph, [&](std::uint32_t /*center*/) { return options.radius; }, contract,
      progress.part(0.4, 1));
  return result;
}

} // namespace espalier
