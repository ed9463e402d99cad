#include "core/reconstruct/growing_tree.h"

#include "core/base/spatial_index.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace espalier {

std::uint32_t GrowingTree::add(const Eigen::Vector3d& place, std::optional<std::uint32_t> parent) {
  const auto number = static_cast<std::uint32_t>(places_.size());
  places_.push_back(place);
  densities_.push_back(attractors_.densityAt(place));
  steps_.push_back(step_.at(densities_.back()));
  ids_.push_back(skeleton_.add(
      {.position = place, .parent = parent ? std::optional<NodeId>(ids_[*parent]) : std::nullopt}));
  attractors_.meet(number, place, kill_ * steps_.back(), reach_ * steps_.back());
  return number;
}

std::optional<GrowingTree::Shoot>
GrowingTree::shootTowards(std::uint32_t node, const std::vector<std::uint32_t>& pulling) const {
  const Eigen::Vector3d& from = places_[node];
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const std::uint32_t point : pulling)
    sum += (attractors_.position(point) - from).normalized();
  if (sum.norm() <= 1e-6 * static_cast<double>(pulling.size())) return std::nullopt;
  const double step = steps_[node];
  const Eigen::Vector3d place = from + step * sum.normalized();
  const bool comesNearer = std::ranges::any_of(pulling, [&](std::uint32_t point) {
    const Eigen::Vector3d position = attractors_.position(point);
    return (position - place).norm() < (position - from).norm() - step / 10;
  });
  if (!comesNearer) return std::nullopt;
  return Shoot{node, place};
}

std::vector<GrowingTree::Shoot> GrowingTree::shootsAcrossGaps(double widestGap,
                                                              const Progress& progress) const {
  constexpr std::size_t fewest = 3; // points that tell a twig from dust
  struct Gap {
    float squaredWidth;
    std::uint32_t point;
    std::uint32_t node;
  };
  Eigen::Matrix3Xf nodes(3, static_cast<Eigen::Index>(places_.size()));
  for (std::size_t i = 0; i < places_.size(); ++i)
    nodes.col(static_cast<Eigen::Index>(i)) = places_[i].cast<float>();
  const SpatialIndex index(nodes);
  const double widest = widestGap > 0 ? widestGap : std::numeric_limits<double>::infinity();
  std::vector<Gap> gaps;
  for (const std::uint32_t point : attractors_.unreached()) {
    progress.check();
    const Neighbor nearest = index.nearest(attractors_.position(point).cast<float>(), 1).front();
    if (std::sqrt(static_cast<double>(nearest.squaredDistance)) <= widest)
      gaps.push_back({nearest.squaredDistance, point, static_cast<std::uint32_t>(nearest.index)});
  }
  std::ranges::sort(gaps, {},
                    [](const Gap& gap) { return std::tuple(gap.squaredWidth, gap.point); });
  std::vector<bool> isLeft(attractors_.size(), false); // by point: beside a gap, and not met yet
  std::vector<Shoot> shoots;
  for (std::size_t next = 0; next < gaps.size() && shoots.empty();) {
    // What lies farther off may be nearer to what grows next.
    const double farthest = step_.greatest + 1.25 * std::sqrt(gaps[next].squaredWidth);
    const std::size_t first = next;
    for (; next < gaps.size() && std::sqrt(gaps[next].squaredWidth) <= farthest; ++next)
      isLeft[gaps[next].point] = true;
    for (std::size_t i = first; i < next; ++i) {
      if (!isLeft[gaps[i].point]) continue;
      const Eigen::Vector3d place = attractors_.position(gaps[i].point);
      takeTogether(gaps[i].point, isLeft, progress);
      if (attractors_.around(place, reach_ * step_.greatest).size() >= fewest)
        shoots.push_back({gaps[i].node, place});
    }
  }
  return shoots;
}

void GrowingTree::takeTogether(std::uint32_t first, std::vector<bool>& isLeft,
                               const Progress& progress) const {
  const double apart = reach_ * step_.greatest;
  std::vector<std::uint32_t> stack = {first};
  isLeft[first] = false;
  while (!stack.empty()) {
    progress.check();
    const Eigen::Vector3d place = attractors_.position(stack.back());
    stack.pop_back();
    for (const std::uint32_t point : attractors_.around(place, apart)) {
      if (!isLeft[point]) continue;
      isLeft[point] = false;
      // Those next to it would find little that is new.
      if ((attractors_.position(point) - place).norm() > apart / 2) stack.push_back(point);
    }
  }
}

} // namespace espalier
