#include "core/reconstruct/geodesic_bins.h"

#include "core/base/error.h"
#include "core/graph/components.h"
#include "core/graph/geodesic.h"
#include "core/graph/neighborhood_graph.h"

#include <queue>

#include <algorithm>
#include <cmath>
#include <string>

namespace espalier {
namespace {

constexpr std::uint32_t none = Geodesics::none;

/// The connected parts of the bins.
struct Groups {
  std::vector<std::uint32_t> ofPoint; // none where the root cannot be reached
  std::vector<Eigen::Vector3d> centroids;
  std::vector<double> radii;                        // mean distance to the centroid
  std::vector<std::vector<std::uint32_t>> adjacent; // sorted, each once
  std::uint32_t root = 0;
};

std::vector<std::uint32_t> levelsOf(const Geodesics& ways, double binWidth) {
  std::vector<std::uint32_t> levels(ways.distance.size(), none);
  for (std::size_t i = 0; i < levels.size(); ++i)
    if (std::isfinite(ways.distance[i]))
      levels[i] = static_cast<std::uint32_t>(static_cast<double>(ways.distance[i]) / binWidth);
  return levels;
}

/// Numbers the connected parts of each level.
std::vector<std::uint32_t> groupsOf(const NeighborhoodGraph& graph,
                                    const std::vector<std::uint32_t>& levels) {
  std::vector<std::uint32_t> groups(levels.size(), none);
  std::vector<std::uint32_t> stack;
  std::uint32_t next = 0;
  for (std::size_t first = 0; first < levels.size(); ++first) {
    if (levels[first] == none || groups[first] != none) continue;
    groups[first] = next;
    stack.push_back(static_cast<std::uint32_t>(first));
    while (!stack.empty()) {
      const std::uint32_t point = stack.back();
      stack.pop_back();
      for (const NeighborhoodGraph::Link& link : graph.links(point))
        if (levels[link.to] == levels[point] && groups[link.to] == none) {
          groups[link.to] = next;
          stack.push_back(link.to);
        }
    }
    ++next;
  }
  return groups;
}

void measure(Groups& groups, const Eigen::Matrix3Xf& points, std::size_t count) {
  std::vector<double> sizes(count, 0);
  groups.centroids.assign(count, Eigen::Vector3d::Zero());
  groups.radii.assign(count, 0);
  for (std::size_t i = 0; i < groups.ofPoint.size(); ++i) {
    if (groups.ofPoint[i] == none) continue;
    groups.centroids[groups.ofPoint[i]] += points.col(static_cast<Eigen::Index>(i)).cast<double>();
    sizes[groups.ofPoint[i]] += 1;
  }
  for (std::size_t g = 0; g < count; ++g)
    groups.centroids[g] /= sizes[g];
  for (std::size_t i = 0; i < groups.ofPoint.size(); ++i) {
    const std::uint32_t g = groups.ofPoint[i];
    if (g == none) continue;
    const Eigen::Vector3d point = points.col(static_cast<Eigen::Index>(i)).cast<double>();
    groups.radii[g] += (point - groups.centroids[g]).norm() / sizes[g];
  }
}

Groups groupPoints(const NeighborhoodGraph& graph, const Eigen::Matrix3Xf& points,
                   Eigen::Index root, double binWidth, const Progress& progress) {
  const Geodesics ways = geodesics(graph, {root}, 1, progress);
  const auto reached = std::count_if(ways.distance.begin(), ways.distance.end(),
                                     [](float d) { return std::isfinite(d); });
  if (2 * reached < points.cols())
    throw Error("only " + std::to_string(100 * reached / points.cols()) +
                " % of the points hang together with the root: choose another root, or allow wider "
                "gaps");
  Groups groups;
  groups.ofPoint = groupsOf(graph, levelsOf(ways, binWidth));
  std::uint32_t count = 0;
  for (const std::uint32_t group : groups.ofPoint)
    if (group != none) count = std::max(count, group + 1);
  groups.root = groups.ofPoint[static_cast<std::size_t>(root)];
  measure(groups, points, count);
  groups.adjacent.resize(count);
  for (std::size_t i = 0; i < groups.ofPoint.size(); ++i)
    for (const NeighborhoodGraph::Link& link : graph.links(static_cast<Eigen::Index>(i)))
      if (groups.ofPoint[i] != none && groups.ofPoint[link.to] != groups.ofPoint[i])
        groups.adjacent[groups.ofPoint[i]].push_back(groups.ofPoint[link.to]);
  for (std::vector<std::uint32_t>& list : groups.adjacent) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return groups;
}

/// A tree of the shortest ways over the centroids.
Skeleton treeOf(const Groups& groups) {
  const std::size_t count = groups.centroids.size();
  std::vector<double> distance(count, std::numeric_limits<double>::infinity());
  std::vector<std::uint32_t> parent(count, none);
  std::vector<std::optional<NodeId>> nodes(count);
  using Item = std::pair<double, std::uint32_t>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  distance[groups.root] = 0;
  queue.emplace(0, groups.root);
  Skeleton skeleton;
  while (!queue.empty()) {
    const auto [at, group] = queue.top();
    queue.pop();
    if (nodes[group]) continue;
    nodes[group] =
        skeleton.add({.position = groups.centroids[group],
                      .radius = groups.radii[group],
                      .parent = parent[group] == none ? std::nullopt : nodes[parent[group]]});
    for (const std::uint32_t next : groups.adjacent[group]) {
      const double through = at + (groups.centroids[group] - groups.centroids[next]).norm();
      if (nodes[next] || through >= distance[next]) continue;
      distance[next] = through;
      parent[next] = group;
      queue.emplace(through, next);
    }
  }
  return skeleton;
}

} // namespace

Skeleton skeletonByGeodesicBins(const Eigen::Matrix3Xf& points, Eigen::Index root,
                                const GeodesicBinOptions& options, const Progress& progress) {
  const NeighborhoodGraph parts(points, options.neighbors, progress.part(0, 0.4));
  const float widestGap = options.widestGap > 0 ? static_cast<float>(options.widestGap)
                                                : std::numeric_limits<float>::max();
  const NeighborhoodGraph graph = joined(parts, points, widestGap, progress.part(0.4, 0.6));
  const Groups groups = groupPoints(graph, points, root, options.binWidth, progress.part(0.6, 0.9));
  Skeleton skeleton = treeOf(groups);
  progress.update(1);
  return skeleton;
}

} // namespace espalier
