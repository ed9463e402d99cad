#include "core/graph/find_root.h"

#include "core/cloud/point_cloud.h"
#include "core/graph/components.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace espalier {
namespace {

std::vector<Eigen::Index> lowestColumns(const Eigen::Matrix3Xf& points, UpAxis up) {
  constexpr float share = 0.02F;
  const auto heights = points.row(static_cast<Eigen::Index>(up));
  const float limit = heights.minCoeff() + share * (heights.maxCoeff() - heights.minCoeff());
  std::vector<Eigen::Index> columns;
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    if (heights[i] <= limit) columns.push_back(i);
  return columns;
}

} // namespace

Eigen::Index findRoot(const Eigen::Matrix3Xf& points, UpAxis up, const Progress& progress) {
  const std::vector<Eigen::Index> slab = lowestColumns(points, up);
  const Eigen::Matrix3Xf low = points(Eigen::all, slab);
  const Components patches = connectedComponents(NeighborhoodGraph(low, 6, progress));
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < low.cols(); ++i)
    if (patches.ofPoint[static_cast<std::size_t>(i)] == 0) mean += low.col(i).cast<double>();
  mean /= static_cast<double>(patches.sizes.front());
  Eigen::Index best = 0;
  double bestDistance = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < low.cols(); ++i) {
    const double distance = (low.col(i).cast<double>() - mean).squaredNorm();
    if (patches.ofPoint[static_cast<std::size_t>(i)] != 0 || distance >= bestDistance) continue;
    best = i;
    bestDistance = distance;
  }
  return slab[static_cast<std::size_t>(best)];
}

Eigen::Index nearestPoint(const Eigen::Matrix3Xf& points, const Eigen::Vector3f& place) {
  Eigen::Index best = 0;
  (points.colwise() - place).colwise().squaredNorm().minCoeff(&best);
  return best;
}

} // namespace espalier
