#include "core/graph/geodesic.h"

#include <queue>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

// A type, not a function: the heap then holds its code instead of calling it.
struct IsFarther {
  bool operator()(const GeodesicBall::Member& a, const GeodesicBall::Member& b) const {
    return a.distance != b.distance ? a.distance > b.distance : a.point > b.point;
  }
};

} // namespace

Geodesics geodesics(const NeighborhoodGraph& graph, const std::vector<Eigen::Index>& sources,
                    double power, const Progress& progress) {
  const auto count = static_cast<std::size_t>(graph.size());
  Geodesics result{std::vector<float>(count, infinite),
                   std::vector<std::uint32_t>(count, Geodesics::none)};
  using Member = GeodesicBall::Member;
  std::vector<Member> storage;
  storage.reserve(count);
  std::priority_queue<Member, std::vector<Member>, IsFarther> queue({}, std::move(storage));
  for (const Eigen::Index source : sources) {
    result.distance[static_cast<std::size_t>(source)] = 0;
    queue.push({static_cast<std::uint32_t>(source), 0});
  }
  const auto costOf = [power](float length) {
    if (power == 1) return length;
    return power == 2 ? length * length : std::pow(length, static_cast<float>(power));
  };
  std::size_t settled = 0;
  while (!queue.empty()) {
    const Member near = queue.top();
    queue.pop();
    if (near.distance > result.distance[near.point]) continue;
    if (++settled % 8192 == 0)
      progress.update(static_cast<double>(settled) / static_cast<double>(count));
    for (const NeighborhoodGraph::Link& link : graph.links(near.point)) {
      const float distance = near.distance + costOf(link.length);
      if (distance >= result.distance[link.to]) continue;
      result.distance[link.to] = distance;
      result.predecessor[link.to] = near.point;
      queue.push({link.to, distance});
    }
  }
  progress.update(1);
  return result;
}

GeodesicBall::GeodesicBall(const NeighborhoodGraph& graph)
    : graph_(graph), distance_(static_cast<std::size_t>(graph.size()), infinite) {}

const std::vector<GeodesicBall::Member>& GeodesicBall::around(Eigen::Index center, float radius,
                                                              std::size_t most) {
  members_.clear();
  met_.clear();
  heap_.clear();
  const auto first = static_cast<std::uint32_t>(center);
  distance_[first] = 0;
  met_.push_back(first);
  heap_.push_back({first, 0});
  while (!heap_.empty() && members_.size() < most) {
    const Member near = heap_.front();
    std::pop_heap(heap_.begin(), heap_.end(), IsFarther{});
    heap_.pop_back();
    if (near.distance > distance_[near.point]) continue;
    members_.push_back(near);
    for (const NeighborhoodGraph::Link& link : graph_.links(near.point)) {
      const float distance = near.distance + link.length;
      float& known = distance_[link.to];
      if (distance > radius || distance >= known) continue;
      if (known == infinite) met_.push_back(link.to);
      known = distance;
      heap_.push_back({link.to, distance});
      std::push_heap(heap_.begin(), heap_.end(), IsFarther{});
    }
  }
  for (const std::uint32_t point : met_)
    distance_[point] = infinite;
  return members_;
}

} // namespace espalier
