#include "core/contract/one_step_laplacian.h"

#include "core/base/parallel.h"
#include "core/base/spatial_index.h"

namespace espalier {

Eigen::Matrix3Xf contractedByOneLaplacianStep(const Eigen::Matrix3Xf& points, int neighbors,
                                              const Progress& progress) {
  const NearestOthers others =
      SpatialIndex(points, progress).nearestOthers(neighbors, progress.part(0, 0.8));
  if (others.perPoint == 0) return points;
  Eigen::Matrix3Xf result(3, points.cols());
  const auto contract = [&](Eigen::Index point) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (Eigen::Index k = 0; k < others.perPoint; ++k) {
      const auto place = static_cast<std::size_t>(point * others.perPoint + k);
      sum += points.col(others.indices[place]).cast<double>();
    }
    result.col(point) = (sum / static_cast<double>(others.perPoint)).cast<float>();
  };
  parallelFor(points.cols(), contract, progress.part(0.8, 1));
  return result;
}

} // namespace espalier
