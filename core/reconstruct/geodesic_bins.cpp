#include "core/reconstruct/geodesic_bins.h"

#include "core/graph/arborescence.h"
#include "core/graph/components.h"
#include "core/graph/neighborhood_graph.h"
#include "core/reconstruct/closed_rings.h"
#include "core/reconstruct/geodesic_groups.h"

#include <queue>

#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace espalier {
namespace {

using Groups = GeodesicGroups;

/// A tree of the shortest paths over the centroids.
Skeleton shortestTreeOf(const Groups& groups) {
  const std::size_t count = groups.centroids.size();
  std::vector<double> distance(count, std::numeric_limits<double>::infinity());
  std::vector<std::uint32_t> parent(count, noGroup);
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
                      .parent = parent[group] == noGroup ? std::nullopt : nodes[parent[group]]});
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

/// What it costs to attach a group to another.
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
  Groups groups = geodesicGroups(graph, points, root, options.binWidth, progress.part(0.6, 0.9));
  if (options.ring > 0)
    groups = withClosedRings(std::move(groups), points, options.ring * options.binWidth);
  Skeleton skeleton =
      options.turnCost > 0 ? cheapestTreeOf(groups, options.turnCost) : shortestTreeOf(groups);
  progress.update(1);
  return skeleton;
}

} // namespace espalier
