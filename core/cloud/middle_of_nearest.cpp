#include "core/cloud/middle_of_nearest.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace espalier {
namespace {

struct Found {
  float squaredDistance;
  Eigen::Index point;
};

} // namespace

std::optional<Eigen::Vector3d> middleOfNearest(const Eigen::Matrix3Xf& points,
                                               const Eigen::Vector3d& origin,
                                               const PointSet& without,
                                               const Eigen::Vector3d& place, double reach) {
  constexpr std::size_t most = 5; // as where nodes stick to points: one alone is noise
  const Eigen::Vector3f local = (place - origin).cast<float>();
  auto worst = static_cast<float>(reach * reach);
  std::vector<Found> nearest; // nearest first
  const auto look = [&](Eigen::Index begin, Eigen::Index end) {
    for (Eigen::Index i = begin; i < end; ++i) {
      const float distance = (points.col(i) - local).squaredNorm();
      if (distance > worst) continue;
      if (nearest.size() == most) nearest.pop_back();
      nearest.insert(std::ranges::upper_bound(nearest, distance, {}, &Found::squaredDistance),
                     {distance, i});
      if (nearest.size() == most) worst = nearest.back().squaredDistance;
    }
  };
  const PointSet counting = PointSet::firstOf(points.cols()) - without;
  for (const PointSet::Run& run : counting.runs())
    look(run.begin, run.end);
  if (nearest.empty()) return std::nullopt;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Found& found : nearest)
    sum += points.col(found.point).cast<double>();
  return origin + sum / static_cast<double>(nearest.size());
}

} // namespace espalier
