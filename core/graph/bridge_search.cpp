#include "core/graph/bridge_search.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <memory>
#include <numeric>
#include <tuple>

namespace espalier {
namespace {

constexpr std::uint32_t mostInLeaf = 16; // points

/// Lowers a value that many threads lower.
void lower(std::atomic<float>& value, float to) {
  float now = value.load(std::memory_order_relaxed);
  while (to < now && !value.compare_exchange_weak(now, to, std::memory_order_relaxed)) {
  }
}

} // namespace

bool Bridge::operator<(const Bridge& other) const {
  return std::tuple(squaredLength, std::min(from, to), std::max(from, to)) <
         std::tuple(other.squaredLength, std::min(other.from, other.to),
                    std::max(other.from, other.to));
}

float BridgeSearch::Part::squaredDistance(const Eigen::Vector3f& place) const {
  return (place - place.cwiseMax(low).cwiseMin(high)).squaredNorm();
}

BridgeSearch::BridgeSearch(const Eigen::Matrix3Xf& points, const Progress& progress)
    : points_(points) {
  order_.resize(static_cast<std::size_t>(points.cols()));
  std::iota(order_.begin(), order_.end(), 0U);
  parts_.push_back(
      {.low = {}, .high = {}, .begin = 0, .end = static_cast<std::uint32_t>(order_.size())});
  for (std::size_t first = 0; first < parts_.size();) { // level by level
    const std::size_t end = parts_.size();
    for (std::size_t part = first; part < end; ++part)
      addHalves(part);
    const auto count = static_cast<Eigen::Index>(end - first);
    const auto divide = [&](Eigen::Index i) { split(parts_[first + static_cast<std::size_t>(i)]); };
    parallelFor(count, divide, progress.part(0, 0), 1 + count / 256);
    first = end;
  }
}

void BridgeSearch::addHalves(std::size_t part) {
  const std::uint32_t begin = parts_[part].begin;
  const std::uint32_t end = parts_[part].end;
  if (end - begin <= mostInLeaf) return;
  const std::uint32_t middle = begin + (end - begin) / 2;
  parts_[part].left = static_cast<std::uint32_t>(parts_.size());
  parts_.push_back({.low = {}, .high = {}, .begin = begin, .end = middle});
  parts_.push_back({.low = {}, .high = {}, .begin = middle, .end = end});
}

void BridgeSearch::split(Part& part) {
  part.low.setConstant(std::numeric_limits<float>::max());
  part.high = -part.low;
  for (std::uint32_t k = part.begin; k < part.end; ++k) {
    part.low = part.low.cwiseMin(points_.col(order_[k]));
    part.high = part.high.cwiseMax(points_.col(order_[k]));
  }
  if (part.isLeaf()) return;
  Eigen::Index axis = 0;
  (part.high - part.low).maxCoeff(&axis);
  const auto place = [&](std::uint32_t k) { return order_.begin() + std::ptrdiff_t(k); };
  std::nth_element(place(part.begin), place(parts_[part.left].end), place(part.end),
                   [&](std::uint32_t a, std::uint32_t b) {
                     return std::tuple(points_(axis, a), a) < std::tuple(points_(axis, b), b);
                   });
}

void BridgeSearch::label(const std::vector<std::uint32_t>& componentOf) {
  for (std::size_t i = parts_.size(); i-- > 0;) { // halves come behind their whole
    Part& part = parts_[i];
    if (!part.isLeaf()) {
      const std::uint32_t left = parts_[part.left].component;
      part.component = left == parts_[part.left + 1].component ? left : mixed;
      continue;
    }
    if (part.begin == part.end) continue;
    part.component = componentOf[order_[part.begin]];
    for (std::uint32_t k = part.begin; k < part.end; ++k)
      if (componentOf[order_[k]] != part.component) part.component = mixed;
  }
}

Bridge BridgeSearch::from(std::uint32_t point, const std::vector<std::uint32_t>& componentOf,
                          float squaredReach) const {
  const Eigen::Vector3f place = points_.col(point);
  const std::uint32_t own = componentOf[point];
  Bridge best;
  float reach = squaredReach;
  std::array<std::uint32_t, 64> open; // halving 2^32 points leaves no more
  std::size_t count = 0;
  open[count++] = 0;
  while (count > 0) {
    const Part& part = parts_[open[--count]];
    if (part.component == own || part.squaredDistance(place) > reach) continue;
    if (!part.isLeaf()) {
      const bool leftIsNearer =
          parts_[part.left].squaredDistance(place) <= parts_[part.left + 1].squaredDistance(place);
      open[count++] = part.left + (leftIsNearer ? 1 : 0);
      open[count++] = part.left + (leftIsNearer ? 0 : 1); // looked at first
      continue;
    }
    for (std::uint32_t k = part.begin; k < part.end; ++k) {
      const std::uint32_t other = order_[k];
      if (componentOf[other] == own) continue;
      const Bridge bridge{(points_.col(other) - place).squaredNorm(), point, other};
      if (bridge.squaredLength > reach || !(bridge < best)) continue;
      best = bridge;
      reach = bridge.squaredLength;
    }
  }
  return best;
}

std::vector<Bridge> BridgeSearch::shortest(const std::vector<std::uint32_t>& componentOf,
                                           std::size_t count, float widest,
                                           const Progress& progress) {
  label(componentOf);
  std::vector<std::uint32_t> searched; // in the order of the tree: what is near comes next
  for (const std::uint32_t point : order_)
    if (componentOf[point] != 0) searched.push_back(point);
  // What each component has found so far prunes; ties are kept, so that the order does not count.
  const auto reaches = std::make_unique<std::atomic<float>[]>(count);
  const float most = std::min(widest, 1e18F);
  for (std::size_t i = 0; i < count; ++i)
    reaches[i] = most * most;
  std::vector<Bridge> found(searched.size());
  const auto search = [&](Eigen::Index i) {
    const std::uint32_t point = searched[static_cast<std::size_t>(i)];
    std::atomic<float>& reach = reaches[componentOf[point]];
    const Bridge bridge = from(point, componentOf, reach.load(std::memory_order_relaxed));
    if (bridge.exists()) lower(reach, bridge.squaredLength);
    found[static_cast<std::size_t>(i)] = bridge;
  };
  parallelFor(static_cast<Eigen::Index>(searched.size()), search, progress, 64);
  std::vector<Bridge> best(count);
  for (const Bridge& bridge : found)
    if (bridge.exists()) {
      Bridge& shortest = best[componentOf[bridge.from]];
      shortest = std::min(shortest, bridge);
    }
  return best;
}

} // namespace espalier
