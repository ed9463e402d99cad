#include "core/contract/euclidean_ball.h"

#include "core/base/ball_sums.h"
#include "core/base/parallel.h"

namespace espalier {

Eigen::Matrix3Xf contractedToBallMeans(const Eigen::Matrix3Xf& points, double radius,
                                       const Progress& progress) {
  const BallSums sums(points, progress);
  Eigen::Matrix3Xf result(3, points.cols());
  const auto contract = [&](Eigen::Index point) {
    const BallSums::Sum sum = sums.within(points.col(point), static_cast<float>(radius));
    result.col(point) = (sum.positions / static_cast<double>(sum.count)).cast<float>();
  };
  parallelFor(points.cols(), contract, progress.part(0.2, 1), 64);
  return result;
}

} // namespace espalier
