#include "core/clean/crop.h"

#include <cmath>

namespace espalier {
namespace {

template <class IsInside>
std::vector<bool> outsideOf(const Eigen::Matrix3Xf& points, const IsInside& isInside) {
  std::vector<bool> result(static_cast<std::size_t>(points.cols()));
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    result[static_cast<std::size_t>(i)] = !isInside(Eigen::Vector3d(points.col(i).cast<double>()));
  return result;
}

} // namespace

std::vector<bool> outsideSlab(const Eigen::Matrix3Xf& points, const SlabOptions& options) {
  if (points.cols() == 0) return {};
  const auto lowest = static_cast<double>(points.row(2).minCoeff());
  return outsideOf(points, [&](const Eigen::Vector3d& point) {
    return point.z() - lowest >= options.from && point.z() - lowest <= options.to;
  });
}

std::vector<bool> outsideDistance(const Eigen::Matrix3Xf& points, const Eigen::Vector3f& foot,
                                  const DistanceOptions& options) {
  const Eigen::Vector3d about = foot.cast<double>();
  return outsideOf(points, [&](const Eigen::Vector3d& point) {
    return (point - about).head<2>().norm() <= options.distance;
  });
}

std::vector<bool> outsideBox(const Eigen::Matrix3Xf& points, const Eigen::Vector3f& foot,
                             const BoxOptions& options) {
  const Eigen::Vector3d about = foot.cast<double>();
  return outsideOf(points, [&](const Eigen::Vector3d& point) {
    const Eigen::Vector3d d = point - about;
    return std::abs(d.x()) <= options.width / 2 && std::abs(d.y()) <= options.depth / 2 &&
           d.z() >= 0 && d.z() <= options.height;
  });
}

} // namespace espalier
