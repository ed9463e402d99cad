#include "core/clean/point_pyramid.h"

#include "core/base/parallel.h"

#include <utility>

namespace espalier {
namespace {

constexpr Eigen::Index fewerBy = 4;

Eigen::Matrix3Xf everyFourth(const Eigen::Matrix3Xf& points) {
  return points(Eigen::all, Eigen::seqN(0, (points.cols() + fewerBy - 1) / fewerBy, fewerBy));
}

std::vector<std::uint32_t> nearestIn(const SpatialIndex& above, const Eigen::Matrix3Xf& points,
                                     const Progress& progress) {
  std::vector<std::uint32_t> nearest(static_cast<std::size_t>(points.cols()));
  parallelFor(
      points.cols(),
      [&](Eigen::Index i) {
        nearest[static_cast<std::size_t>(i)] =
            static_cast<std::uint32_t>(above.nearestOne(points.col(i))->index);
      },
      progress);
  return nearest;
}

} // namespace

PointPyramid::PointPyramid(const Eigen::Matrix3Xf& points, int neighbors, std::size_t mostLevels,
                           const Progress& progress) {
  Eigen::Matrix3Xf next = points;
  while (levels_.size() < mostLevels && (levels_.empty() || next.cols() > 2 * neighbors)) {
    const Progress part = progress.part(levels_.empty() ? 0 : 0.75, levels_.empty() ? 0.75 : 1);
    const SpatialIndex index(next, part);
    if (!levels_.empty())
      levels_.back().above = nearestIn(index, levels_.back().points, part.part(0, 0.3));
    NearestOthers nearest = index.nearestOthers(neighbors, part.part(0.3, 1));
    Eigen::Matrix3Xf fewer = everyFourth(next);
    levels_.push_back({std::move(next), std::move(nearest), {}});
    next = std::move(fewer);
  }
}

} // namespace espalier
