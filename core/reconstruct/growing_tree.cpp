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

GrowingTree::Sprout GrowingTree::sproutAt(const Eigen::Vector3d& place) const {
  const double density = attractors_.densityAt(place);
  const double step = step_.at(density);
  return {density, step, attractors_.metBy(place, kill_ * step, reach_ * step)};
}

std::uint32_t GrowingTree::add(const Sprout& sprout, const Eigen::Vector3d& place,
                               std::optional<std::uint32_t> parent) {
  const auto number = static_cast<std::uint32_t>(places_.size());
  places_.push_back(place);
  densities_.push_back(sprout.density);
  steps_.push_back(sprout.step);
  parents_.push_back(parent ? std::optional(NodeId{*parent}) : std::nullopt);
  attractors_.meet(number, sprout.met, kill_ * sprout.step);
  return number;
}

std::uint32_t GrowingTree::addRoot(const Eigen::Vector3d& place) {
  return add(sproutAt(place), place, std::nullopt);
}

std::vector<std::uint32_t> GrowingTree::add(const std::vector<Shoot>& shoots,
                                            const Progress& progress) {
  std::vector<Sprout> sprouts(shoots.size());
  const auto sprout = [&](Eigen::Index i) {
    sprouts[static_cast<std::size_t>(i)] = sproutAt(shoots[static_cast<std::size_t>(i)].place);
  };
  parallelFor(static_cast<Eigen::Index>(shoots.size()), sprout, progress.part(0, 0), 8);
  std::vector<std::uint32_t> numbers;
  for (std::size_t i = 0; i < shoots.size(); ++i)
    numbers.push_back(add(sprouts[i], shoots[i].place, shoots[i].parent));
  return numbers;
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

Skeleton GrowingTree::skeleton() const {
  Skeleton skeleton;
  skeleton.reserve(places_.size());
  for (std::size_t i = 0; i < places_.size(); ++i)
    skeleton.add({.position = places_[i], .parent = parents_[i]});
  return skeleton;
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
  const auto first = static_cast<std::uint32_t>(nodesOfGaps_);
  const auto update = [&](Eigen::Index i) {
    Gap& gap = gaps_[static_cast<std::size_t>(i)];
    const float reach =
        std::nextafter(std::sqrt(gap.squaredWidth), std::numeric_limits<float>::max());
    const auto nearest = index.nearestOne(attractors_.position(gap.point).cast<float>(), reach);
    if (nearest && nearest->squaredDistance < gap.squaredWidth)
      gap = {nearest->squaredDistance, gap.point,
             first + static_cast<std::uint32_t>(nearest->index)};
  };
  parallelFor(static_cast<Eigen::Index>(gaps_.size()), update, progress.part(0, 0));
  nodesOfGaps_ = places_.size();
}

std::vector<GrowingTree::Gap> GrowingTree::nearestGaps(float beyond, double widest) const {
  const auto isAhead = [&](const Gap& gap) {
    return gap.squaredWidth > beyond && std::sqrt(static_cast<double>(gap.squaredWidth)) <= widest;
  };
  float least = std::numeric_limits<float>::infinity();
  for (const Gap& gap : gaps_)
    if (gap.squaredWidth < least && isAhead(gap)) least = gap.squaredWidth;
  // What lies farther off may be nearer to what grows next.
  const double farthest = step_.greatest + 1.25 * std::sqrt(least);
  std::vector<Gap> nearest;
  for (const Gap& gap : gaps_)
    if (std::sqrt(gap.squaredWidth) <= farthest && isAhead(gap)) nearest.push_back(gap);
  std::ranges::sort(nearest, {},
                    [](const Gap& gap) { return std::tuple(gap.squaredWidth, gap.point); });
  return nearest;
}

std::vector<GrowingTree::Gap> GrowingTree::onePerClump(const std::vector<Gap>& gaps,
                                                       const Progress& progress) const {
  const double apart = reach_ * step_.greatest;
  Eigen::Matrix3Xf places(3, static_cast<Eigen::Index>(gaps.size()));
  for (std::size_t i = 0; i < gaps.size(); ++i)
    places.col(static_cast<Eigen::Index>(i)) = attractors_.position(gaps[i].point).cast<float>();
  const SpatialIndex index(places, progress);
  std::vector<bool> isLeft(gaps.size(), true);
  std::vector<Gap> first;
  std::vector<std::size_t> stack;
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    if (!isLeft[i]) continue;
    first.push_back(gaps[i]);
    isLeft[i] = false;
    stack.push_back(i);
    while (!stack.empty()) {
      progress.check();
      const auto at = static_cast<Eigen::Index>(stack.back());
      const Eigen::Vector3d place = attractors_.position(gaps[stack.back()].point);
      stack.pop_back();
      found.clear();
      for (const Neighbor& near : index.within(places.col(at), static_cast<float>(apart)))
        if (const auto other = static_cast<std::size_t>(near.index); isLeft[other])
          found.push_back(other);
      std::ranges::sort(found, {}, [&](std::size_t other) { return gaps[other].point; });
      for (const std::size_t other : found) {
        isLeft[other] = false;
        // Those next to it would find little that is new.
        if ((attractors_.position(gaps[other].point) - place).norm() > apart / 2)
          stack.push_back(other);
      }
    }
  }
  return first;
}

std::vector<GrowingTree::Shoot> GrowingTree::shootsAcrossGaps(double widestGap,
                                                              const Progress& progress) {
  constexpr std::size_t fewest = 3; // points that distinguish a twig from dust
  updateGaps(progress);
  const double widest = widestGap > 0 ? widestGap : std::numeric_limits<double>::infinity();
  isDust_.resize(attractors_.size(), false);
  std::vector<Shoot> shoots;
  for (std::vector<Gap> gaps = nearestGaps(-1, widest); !gaps.empty() && shoots.empty();
       gaps = nearestGaps(gaps.back().squaredWidth, widest))
    for (const Gap& gap : onePerClump(gaps, progress)) {
      if (isDust_[gap.point]) continue;
      const Eigen::Vector3d place = attractors_.position(gap.point);
      if (attractors_.around(place, reach_ * step_.greatest).size() >= fewest)
        shoots.push_back({gap.node, place});
      else
        isDust_[gap.point] = true;
    }
  return shoots;
}

} // namespace espalier
