#include "core/reconstruct/geodesic_groups.h"

#include "core/graph/geodesic.h"
#include "core/reconstruct/reached_points.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr std::uint32_t none = GeodesicGroups::none;

std::vector<std::uint32_t> binsOf(const Geodesics& ways, double binWidth) {
  std::vector<std::uint32_t> bins(ways.distance.size(), none);
  for (std::size_t i = 0; i < bins.size(); ++i)
    if (std::isfinite(ways.distance[i]))
      bins[i] = static_cast<std::uint32_t>(static_cast<double>(ways.distance[i]) / binWidth);
  return bins;
}

/// Numbers the connected parts of each bin.
std::vector<std::uint32_t> groupsOf(const NeighborhoodGraph& graph,
                                    const std::vector<std::uint32_t>& bins) {
  std::vector<std::uint32_t> groups(bins.size(), none);
  std::vector<std::uint32_t> stack;
  std::uint32_t next = 0;
  for (std::size_t first = 0; first < bins.size(); ++first) {
    if (bins[first] == none || groups[first] != none) continue;
    groups[first] = next;
    stack.push_back(static_cast<std::uint32_t>(first));
    while (!stack.empty()) {
      const std::uint32_t point = stack.back();
      stack.pop_back();
      for (const NeighborhoodGraph::Link& link : graph.links(point))
        if (bins[link.to] == bins[point] && groups[link.to] == none) {
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

void measure(GeodesicGroups& groups, const Eigen::Matrix3Xf& points, std::size_t count) {
  std::vector<double>& sizes = groups.sizes;
  sizes.assign(count, 0);
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

} // namespace

GeodesicGroups geodesicGroups(const NeighborhoodGraph& graph, const Eigen::Matrix3Xf& points,
                              Eigen::Index root, double binWidth, const Progress& progress) {
  Geodesics ways = geodesics(graph, {root}, 1, progress);
  const auto reached = std::count_if(ways.distance.begin(), ways.distance.end(),
                                     [](float d) { return std::isfinite(d); });
  requireHalf(reached, points.cols());
  GeodesicGroups groups;
  const std::vector<std::uint32_t> bins = binsOf(ways, binWidth);
  groups.ofPoint = groupsOf(graph, bins);
  groups.distances = std::move(ways.distance);
  std::uint32_t count = 0;
  for (const std::uint32_t group : groups.ofPoint)
    if (group != none) count = std::max(count, group + 1);
  groups.root = groups.ofPoint[static_cast<std::size_t>(root)];
  groups.bins.resize(count);
  for (std::size_t i = 0; i < bins.size(); ++i)
    if (bins[i] != none) groups.bins[groups.ofPoint[i]] = bins[i];
  measure(groups, points, count);
  groups.adjacent.resize(count);
  for (std::size_t i = 0; i < groups.ofPoint.size(); ++i) {
    const std::uint32_t own = groups.ofPoint[i];
    if (own == none) continue;
    std::vector<std::uint32_t>& list = groups.adjacent[own];
    for (const NeighborhoodGraph::Link& link : graph.links(static_cast<Eigen::Index>(i)))
      if (const std::uint32_t other = groups.ofPoint[link.to];
          other != own && (list.empty() || list.back() != other))
        list.push_back(other);
  }
  for (std::vector<std::uint32_t>& list : groups.adjacent) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return groups;
}

} // namespace espalier
