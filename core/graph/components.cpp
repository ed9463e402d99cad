#include "core/graph/components.h"

#include "core/graph/bridge_search.h"
#include "core/graph/disjoint_sets.h"

#include <algorithm>
#include <numeric>

namespace espalier {
namespace {

constexpr std::uint32_t unseen = std::numeric_limits<std::uint32_t>::max();

} // namespace

Components connectedComponents(const NeighborhoodGraph& graph) {
  Components result;
  result.ofPoint.assign(static_cast<std::size_t>(graph.size()), unseen);
  std::vector<std::uint32_t> stack;
  for (std::size_t first = 0; first < result.ofPoint.size(); ++first) {
    if (result.ofPoint[first] != unseen) continue;
    const auto number = static_cast<std::uint32_t>(result.sizes.size());
    Eigen::Index size = 0;
    stack.push_back(static_cast<std::uint32_t>(first));
    result.ofPoint[first] = number;
    while (!stack.empty()) {
      const std::uint32_t point = stack.back();
      stack.pop_back();
      ++size;
      for (const NeighborhoodGraph::Link& link : graph.links(point))
        if (result.ofPoint[link.to] == unseen) {
          result.ofPoint[link.to] = number;
          stack.push_back(link.to);
        }
    }
    result.sizes.push_back(size);
  }
  std::vector<std::uint32_t> order(result.sizes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(),
                   [&](auto a, auto b) { return result.sizes[a] > result.sizes[b]; });
  std::vector<std::uint32_t> rank(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i)
    rank[order[i]] = i;
  for (std::uint32_t& number : result.ofPoint)
    number = rank[number];
  std::sort(result.sizes.begin(), result.sizes.end(), std::greater<>());
  return result;
}

std::vector<Eigen::Index> pointsLinkedTo(const NeighborhoodGraph& graph, Eigen::Index first,
                                         float longest, std::vector<bool>& isMet) {
  std::vector<Eigen::Index> points = {first};
  isMet[static_cast<std::size_t>(first)] = true;
  for (std::size_t next = 0; next < points.size(); ++next)
    for (const NeighborhoodGraph::Link& link : graph.links(points[next])) {
      if (link.length > longest || isMet[link.to]) continue;
      isMet[link.to] = true;
      points.push_back(link.to);
    }
  std::ranges::sort(points);
  return points;
}

NeighborhoodGraph joined(const NeighborhoodGraph& graph, const Eigen::Matrix3Xf& points,
                         float widestGap, const Progress& progress) {
  Components components = connectedComponents(graph);
  std::vector<NeighborhoodGraph::Edge> bridges;
  if (components.count() < 2) return graph;
  BridgeSearch search(points, progress);
  const auto startCount = static_cast<double>(components.count());
  while (components.count() > 1) {
    const double done = 1 - static_cast<double>(components.count()) / startCount;
    DisjointSets sets(components.count());
    bool anyJoined = false;
    const std::vector<Bridge> shortest =
        search.shortest(components.ofPoint, components.count(), widestGap,
                        progress.part(done, done + (1 - done) / 2));
    for (const Bridge& bridge : shortest) {
      if (!bridge.exists()) continue;
      if (!sets.join(components.ofPoint[bridge.from], components.ofPoint[bridge.to])) continue;
      bridges.emplace_back(bridge.from, bridge.to);
      anyJoined = true;
    }
    if (!anyJoined) break; // the gaps left are too wide
    // Number the joined components by the lowest number in them: the largest stays first.
    std::vector<std::uint32_t> numbers(components.count(), unseen);
    std::vector<Eigen::Index> sizes;
    for (std::uint32_t old = 0; old < components.count(); ++old) {
      const std::uint32_t set = sets.find(old);
      if (numbers[set] == unseen) {
        numbers[set] = static_cast<std::uint32_t>(sizes.size());
        sizes.push_back(0);
      }
      sizes[numbers[set]] += components.sizes[old];
    }
    for (std::uint32_t& number : components.ofPoint)
      number = numbers[sets.find(number)];
    components.sizes = std::move(sizes);
  }
  progress.update(1);
  return graph.withLinks(bridges, points);
}

} // namespace espalier
