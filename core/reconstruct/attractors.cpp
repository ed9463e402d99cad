#include "core/reconstruct/attractors.h"

#include <algorithm>
#include <cassert>

namespace espalier {

Attractors::Attractors(const Eigen::Matrix3Xf& points, const std::vector<float>& densities,
                       const Progress& progress)
    : points_(points), densities_(densities), index_(points, progress),
      isAlive_(densities.size(), 1), owner_(densities.size(), none),
      squaredDistance_(densities.size(), std::numeric_limits<float>::infinity()) {
  assert(static_cast<Eigen::Index>(densities.size()) == points.cols());
}

double Attractors::densityAt(const Eigen::Vector3d& place) const {
  const Eigen::Index nearest = index_.nearest(place.cast<float>(), 1).front().index;
  return static_cast<double>(densities_[static_cast<std::size_t>(nearest)]);
}

void Attractors::meet(std::uint32_t node, const Eigen::Vector3d& place, double kill, double reach) {
  assert(node == owned_.size());
  owned_.emplace_back();
  const auto squaredKill = static_cast<float>(kill * kill);
  const auto farthest = static_cast<float>(std::max(kill, reach));
  for (const Neighbor& found : index_.within(place.cast<float>(), farthest)) {
    const auto point = static_cast<std::uint32_t>(found.index);
    if (!isAlive_[point]) continue;
    if (owner_[point] == none) ++reached_;
    if (found.squaredDistance <= squaredKill) {
      isAlive_[point] = 0;
      owner_[point] = node;
      ++dead_;
    } else if (found.squaredDistance < squaredDistance_[point]) {
      squaredDistance_[point] = found.squaredDistance;
      owner_[point] = node;
      owned_.back().push_back(point);
    }
  }
  std::ranges::sort(owned_.back());
}

std::vector<std::uint32_t> Attractors::around(const Eigen::Vector3d& place, double reach) const {
  std::vector<std::uint32_t> living;
  for (const Neighbor& found : index_.within(place.cast<float>(), static_cast<float>(reach)))
    if (isAlive_[static_cast<std::size_t>(found.index)])
      living.push_back(static_cast<std::uint32_t>(found.index));
  std::ranges::sort(living);
  return living;
}

const std::vector<std::uint32_t>& Attractors::of(std::uint32_t node) {
  std::erase_if(owned_[node],
                [&](std::uint32_t point) { return !isAlive_[point] || owner_[point] != node; });
  return owned_[node];
}

} // namespace espalier
