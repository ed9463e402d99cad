#include "core/reconstruct/closed_rings.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace espalier {
namespace {

using Groups = GeodesicGroups;
using Sides = std::pair<std::uint32_t, std::uint32_t>; // groups of one bin

/// Which groups become one: each has a head, the lowest of its set.
class JoinedGroups {
public:
  explicit JoinedGroups(std::size_t count) : heads_(count) {
    std::iota(heads_.begin(), heads_.end(), 0U);
  }

  [[nodiscard]] std::uint32_t headOf(std::uint32_t group) const {
    while (heads_[group] != group)
      group = heads_[group];
    return group;
  }

  void join(const Sides& sides) {
    const std::uint32_t a = headOf(sides.first);
    const std::uint32_t b = headOf(sides.second);
    heads_[std::max(a, b)] = std::min(a, b);
  }

private:
  std::vector<std::uint32_t> heads_;
};

std::vector<std::uint32_t> belowOf(const Groups& groups, std::uint32_t group) {
  std::vector<std::uint32_t> below;
  for (const std::uint32_t other : groups.adjacent[group])
    if (groups.bins[other] + 1 == groups.bins[group]) below.push_back(other);
  return below;
}

/// The sides of a ring from `at` down to where they meet; none if they do not.
std::vector<Sides> ringBelow(const Groups& groups, Sides at, double widest) {
  constexpr int mostBins = 12;
  std::vector<Sides> ring;
  for (int bin = 0; bin < mostBins; ++bin) {
    if ((groups.centroids[at.first] - groups.centroids[at.second]).norm() > widest) return {};
    ring.push_back(at);
    double nearest = std::numeric_limits<double>::infinity();
    const std::vector<std::uint32_t> others = belowOf(groups, at.second);
    for (const std::uint32_t one : belowOf(groups, at.first))
      for (const std::uint32_t other : others) {
        if (one == other) return ring;
        const double apart = (groups.centroids[one] - groups.centroids[other]).norm();
        if (apart >= nearest) continue;
        nearest = apart;
        at = {one, other};
      }
    if (nearest > widest) return {};
  }
  return {};
}

} // namespace

GeodesicGroups withClosedRings(GeodesicGroups groups, const Eigen::Matrix3Xf& points,
                               double widest) {
  const auto count = static_cast<std::uint32_t>(groups.bins.size());
  JoinedGroups joined(count);
  for (std::uint32_t group = 0; group < count; ++group) {
    const std::vector<std::uint32_t> below = belowOf(groups, group);
    for (std::size_t i = 0; i < below.size(); ++i)
      for (std::size_t j = i + 1; j < below.size(); ++j)
        for (const Sides& sides : ringBelow(groups, {below[i], below[j]}, widest))
          joined.join(sides);
  }
  std::vector<std::uint32_t> number(count);
  std::vector<std::uint32_t> bins;
  for (std::uint32_t group = 0; group < count; ++group) {
    const std::uint32_t head = joined.headOf(group); // never above `group`
    if (head == group) {
      number[group] = static_cast<std::uint32_t>(bins.size());
      bins.push_back(groups.bins[group]);
    } else {
      number[group] = number[head];
    }
  }
  if (bins.size() == count) return groups;
  std::vector<std::vector<std::uint32_t>> adjacent(bins.size());
  for (std::uint32_t group = 0; group < count; ++group)
    for (const std::uint32_t other : groups.adjacent[group])
      if (number[other] != number[group]) adjacent[number[group]].push_back(number[other]);
  for (std::vector<std::uint32_t>& list : adjacent) {
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  for (std::uint32_t& group : groups.ofPoint)
    if (group != noGroup) group = number[group];
  groups.root = number[groups.root];
  groups.bins = std::move(bins);
  groups.adjacent = std::move(adjacent);
  measure(groups, points);
  return groups;
}

} // namespace espalier
