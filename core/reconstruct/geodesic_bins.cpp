#include "core/reconstruct/geodesic_bins.h"

#include "core/graph/arborescence.h"
#include "core/graph/components.h"
#include "core/graph/geodesic.h"
#include "core/graph/neighborhood_graph.h"
#include "core/reconstruct/reached_points.h"

#include <Eigen/Eigenvalues>
#include <queue>

#include <algorithm>
#include <cmath>
#include <utility>

namespace espalier {
namespace {

constexpr std::uint32_t none = Geodesics::none;

/// The connected parts of the bins.
struct Groups {
  std::vector<std::uint32_t> ofPoint; // none where the root cannot be reached
  std::vector<Eigen::Vector3d> centroids;
  std::vector<double> radii;         // mean distance to the centroid
  std::vector<Eigen::Vector3d> axes; // of the points; as long as they are linear, in [0, 1]
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

/// The direction in which points lie, as long as they are linear; of one point 0.
Eigen::Vector3d axisOf(const Eigen::Matrix3d& scatter) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  const double widest = solver.eigenvalues()[2];
  if (!(widest > 0)) return Eigen::Vector3d::Zero();
  return (1 - std::max(0.0, solver.eigenvalues()[1]) / widest) * solver.eigenvectors().col(2);
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
  std::vector<Eigen::Matrix3d> scatters(count, Eigen::Matrix3d::Zero());
  for (std::size_t i = 0; i < groups.ofPoint.size(); ++i) {
    const std::uint32_t g = groups.ofPoint[i];
    if (g == none) continue;
    const Eigen::Vector3d d =
        points.col(static_cast<Eigen::Index>(i)).cast<double>() - groups.centroids[g];
    groups.radii[g] += d.norm() / sizes[g];
    scatters[g] += d * d.transpose() / sizes[g];
  }
  groups.axes.reserve(count);
  for (const Eigen::Matrix3d& scatter : scatters)
    groups.axes.push_back(axisOf(scatter));
}

Groups groupPoints(const NeighborhoodGraph& graph, const Eigen::Matrix3Xf& points,
                   Eigen::Index root, double binWidth, const Progress& progress) {
  const Geodesics ways = geodesics(graph, {root}, 1, progress);
  const auto reached = std::count_if(ways.distance.begin(), ways.distance.end(),
                                     [](float d) { return std::isfinite(d); });
  requireHalf(reached, points.cols());
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
Skeleton shortestTreeOf(const Groups& groups) {
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

/// What it costs to hang a group on another.
double costOf(const Groups& groups, std::uint32_t from, std::uint32_t to, double turnCost) {
  const Eigen::Vector3d link = groups.centroids[to] - groups.centroids[from];
  const double length = link.norm();
  if (length == 0) return 0;
  const double linearity = groups.axes[to].norm();
  if (linearity == 0) return length;
  const double across = link.cross(groups.axes[to]).squaredNorm() /
                        (length * length * linearity * linearity); // sin^2
  return length * (1 + turnCost * linearity * across);
}

/// The tree over the centroids that costs least in all.
Skeleton cheapestTreeOf(const Groups& groups, double turnCost) {
  const auto count = static_cast<std::uint32_t>(groups.centroids.size());
  std::vector<DirectedLink> links;
  for (std::uint32_t from = 0; from < count; ++from)
    for (const std::uint32_t to : groups.adjacent[from])
      links.push_back({from, to, costOf(groups, from, to, turnCost)});
  const std::vector<int> chosen = minimumArborescence(count, groups.root, links);
  std::vector<std::vector<std::uint32_t>> carried(count);
  for (std::uint32_t group = 0; group < count; ++group)
    if (chosen[group] >= 0)
      carried[links[static_cast<std::size_t>(chosen[group])].from].push_back(group);
  Skeleton skeleton;
  std::vector<NodeId> nodes(count);
  nodes[groups.root] = skeleton.add(
      {.position = groups.centroids[groups.root], .radius = groups.radii[groups.root]});
  std::vector<std::uint32_t> order = {groups.root};
  order.reserve(count);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const NodeId parent = nodes[order[i]];
    for (const std::uint32_t group : carried[order[i]]) {
      nodes[group] = skeleton.add(
          {.position = groups.centroids[group], .radius = groups.radii[group], .parent = parent});
      order.push_back(group);
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
  Skeleton skeleton =
      options.turnCost > 0 ? cheapestTreeOf(groups, options.turnCost) : shortestTreeOf(groups);
  progress.update(1);
  return skeleton;
}

} // namespace espalier
