#include "core/reconstruct/geodesic_groups.h"

#include "core/graph/geodesic.h"
#include "core/reconstruct/reached_points.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

std::vector<std::uint32_t> binsOf(const Geodesics& paths, double binWidth) {
  std::vector<std::uint32_t> bins(paths.distance.size(), noGroup);
  for (std::size_t i = 0; i < bins.size(); ++i)
    if (std::isfinite(paths.distance[i]))
      bins[i] = static_cast<std::uint32_t>(static_cast<double>(paths.distance[i]) / binWidth);
  return bins;
}

/// Numbers the connected parts of each bin, and lists which touch each other.
void group(GeodesicGroups& groups, const NeighborhoodGraph& graph,
           const std::vector<std::uint32_t>& bins) {
  groups.ofPoint.assign(bins.size(), noGroup);
  const auto touch = [&](std::uint32_t own, std::uint32_t other) {
    std::vector<std::uint32_t>& list = groups.adjacent[own];
    if (list.empty() || list.back() != other) list.push_back(other);
  };
  std::vector<std::uint32_t> stack;
  for (std::size_t first = 0; first < bins.size(); ++first) {
    if (bins[first] == noGroup || groups.ofPoint[first] != noGroup) continue;
    const auto own = static_cast<std::uint32_t>(groups.bins.size());
    groups.bins.push_back(bins[first]);
    groups.adjacent.emplace_back();
    groups.ofPoint[first] = own;
    stack.push_back(static_cast<std::uint32_t>(first));
    while (!stack.empty()) {
      const std::uint32_t point = stack.back();
      stack.pop_back();
      for (const NeighborhoodGraph::Link& link : graph.links(point)) {
        std::uint32_t& other = groups.ofPoint[link.to];
        if (other != noGroup && other != own) { // numbered before: it did not see this group yet
          touch(own, other);
          touch(other, own);
        } else if (other == noGroup && bins[link.to] == groups.bins[own]) {
          other = own;
          stack.push_back(link.to);
        }
      }
    }
  }
  for (std::vector<std::uint32_t>& list : groups.adjacent) {
    std::ranges::sort(list);
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
}

/// The direction in which points lie, as long as they are linear; of one point 0.
Eigen::Vector3d axisOf(const Eigen::Matrix3d& scatter) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(scatter);
  const double widest = solver.eigenvalues()[2];
  if (!(widest > 0)) return Eigen::Vector3d::Zero();
  return (1 - std::max(0.0, solver.eigenvalues()[1]) / widest) * solver.eigenvectors().col(2);
}

} // namespace

void measure(GeodesicGroups& groups, const Eigen::Matrix3Xf& points) {
  const std::size_t count = groups.bins.size();
  std::vector<double>& sizes = groups.sizes;
  sizes.assign(count, 0);
  groups.centroids.assign(count, Eigen::Vector3d::Zero());
  groups.radii.assign(count, 0);
  for (std::size_t i = 0; i < groups.ofPoint.size(); ++i) {
    if (groups.ofPoint[i] == noGroup) continue;
    groups.centroids[groups.ofPoint[i]] += points.col(static_cast<Eigen::Index>(i)).cast<double>();
    sizes[groups.ofPoint[i]] += 1;
  }
  for (std::size_t g = 0; g < count; ++g)
    groups.centroids[g] /= sizes[g];
  std::vector<Eigen::Matrix3d> scatters(count, Eigen::Matrix3d::Zero());
  for (std::size_t i = 0; i < groups.ofPoint.size(); ++i) {
    const std::uint32_t g = groups.ofPoint[i];
    if (g == noGroup) continue;
    const Eigen::Vector3d d =
        points.col(static_cast<Eigen::Index>(i)).cast<double>() - groups.centroids[g];
    groups.radii[g] += d.norm() / sizes[g];
    scatters[g] += d * d.transpose() / sizes[g];
  }
  groups.axes.clear();
  for (const Eigen::Matrix3d& scatter : scatters)
    groups.axes.push_back(axisOf(scatter));
}

GeodesicGroups geodesicGroups(const NeighborhoodGraph& graph, const Eigen::Matrix3Xf& points,
                              Eigen::Index root, double binWidth, const Progress& progress) {
  Geodesics paths = geodesics(graph, {root}, 1, progress);
  const auto reached = std::count_if(paths.distance.begin(), paths.distance.end(),
                                     [](float d) { return std::isfinite(d); });
  requireHalf(reached, points.cols());
  GeodesicGroups groups;
  group(groups, graph, binsOf(paths, binWidth));
  groups.distances = std::move(paths.distance);
  groups.root = groups.ofPoint[static_cast<std::size_t>(root)];
  measure(groups, points);
  return groups;
}

} // namespace espalier
