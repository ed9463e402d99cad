#include "core/reconstruct/growing_tree.h"

#include "core/base/parallel.h"
#include "core/base/spatial_index.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <span>
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

void GrowingTree::updateGaps(const Progress& progress) {
  if (nodesOfGaps_ == 0)
    for (std::uint32_t point = 0; point < attractors_.size(); ++point)
      gaps_.push_back({std::numeric_limits<float>::max(), point, 0});
  std::erase_if(gaps_, [&](const Gap& gap) { return attractors_.isReached(gap.point); });
  const std::span<const Eigen::Vector3d> added = std::span(places_).subspan(nodesOfGaps_);
  Eigen::Matrix3Xf nodes(3, static_cast<Eigen::Index>(added.size()));
  for (std::size_t i = 0; i < added.size(); ++i)
    nodes.col(static_cast<Eigen::Index>(i)) = added[i].cast<float>();
  const SpatialIndex index(nodes, progress);
  constexpr float longest = std::numeric_limits<float>::max();
  const auto first = static_cast<std::uint32_t>(nodesOfGaps_);
  const auto update = [&](Eigen::Index i) {
    Gap& gap = gaps_[static_cast<std::size_t>(i)];
    const float reach = std::nextafter(std::sqrt(gap.squaredWidth), longest);
    const auto nearest = index.nearestIf(attractors_.position(gap.point).cast<float>(), reach,
                                         [](Eigen::Index) { return true; });
    if (nearest && nearest->squaredDistance < gap.squaredWidth)
      gap = {nearest->squaredDistance, gap.point,
             first + static_cast<std::uint32_t>(nearest->index)};
  };
  parallelFor(static_cast<Eigen::Index>(gaps_.size()), update, progress.part(0, 0));
  nodesOfGaps_ = places_.size();
}

std::vector<GrowingTree::Shoot> GrowingTree::shootsAcrossGaps(double widestGap,
                                                              const Progress& progress) {
  constexpr std::size_t fewest = 3; // points that tell a twig from dust
  updateGaps(progress);
  const double widest = widestGap > 0 ? widestGap : std::numeric_limits<double>::infinity();
  std::vector<Gap> gaps;
  std::ranges::copy_if(gaps_, std::back_inserter(gaps), [&](const Gap& gap) {
    return std::sqrt(static_cast<double>(gap.squaredWidth)) <= widest;
  });
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
