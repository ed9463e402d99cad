#include "core/reconstruct/attractors.h"

#include <algorithm>
#include <cassert>

namespace espalier {

Attractors::Attractors(const Eigen::Matrix3Xf& points, const SpatialIndex& index,
                       const std::vector<float>& densities)
    : places_(points), index_(index), densities_(densities), points_(densities.size()) {
  assert(static_cast<Eigen::Index>(densities.size()) == points.cols());
}

double Attractors::densityAt(const Eigen::Vector3d& place) const {
  const Eigen::Index nearest = index_.nearestOne(place.cast<float>())->index;
  return static_cast<double>(densities_[static_cast<std::size_t>(nearest)]);
}

std::vector<Neighbor> Attractors::metBy(const Eigen::Vector3d& place, double kill,
                                        double reach) const {
  const auto squaredKill = static_cast<float>(kill * kill);
  std::vector<Neighbor> met =
      index_.within(place.cast<float>(), static_cast<float>(std::max(kill, reach)));
  std::erase_if(met, [&](const Neighbor& found) {
    const Point& point = points_[static_cast<std::size_t>(found.index)];
    return !point.isAlive() ||
           (found.squaredDistance > squaredKill && found.squaredDistance >= point.squaredDistance);
  });
  return met;
}

void Attractors::meet(std::uint32_t node, const std::vector<Neighbor>& met, double kill) {
  assert(node == owned_.size());
  std::vector<std::uint32_t>& own = owned_.emplace_back();
  own.reserve(met.size());
  const auto squaredKill = static_cast<float>(kill * kill);
  for (const auto& [index, squaredDistance] : met) {
    const auto number = static_cast<std::uint32_t>(index);
    Point& point = points_[number];
    if (!point.isAlive()) continue;
    if (point.owner == none) ++reached_;
    if (squaredDistance <= squaredKill) {
      point = {.squaredDistance = -1, .owner = node};
      ++dead_;
    } else if (squaredDistance < point.squaredDistance) {
      point = {.squaredDistance = squaredDistance, .owner = node};
      own.push_back(number);
    }
  }
  std::ranges::sort(own);
}

std::vector<std::uint32_t> Attractors::around(const Eigen::Vector3d& place, double reach) const {
  std::vector<std::uint32_t> living;
  for (const Neighbor& found : index_.within(place.cast<float>(), static_cast<float>(reach)))
    if (points_[static_cast<std::size_t>(found.index)].isAlive())
      living.push_back(static_cast<std::uint32_t>(found.index));
  std::ranges::sort(living);
  return living;
}

const std::vector<std::uint32_t>& Attractors::of(std::uint32_t node) {
  std::erase_if(owned_[node], [&](std::uint32_t point) {
    return !points_[point].isAlive() || points_[point].owner != node;
  });
  return owned_[node];
}

} // namespace espalier
