#include "core/skeleton/checks_of_scan.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace espalier {
namespace {

using Kind = Finding::Kind;

/// The connected parts of points, those within `gap` [L] of each other being linked. In order of
/// their first points.
std::vector<std::vector<Eigen::Index>> clusters(const Eigen::Matrix3Xf& points, float gap,
                                                const Progress& progress) {
  const SpatialIndex index(points);
  std::vector<bool> isSeen(static_cast<std::size_t>(points.cols()), false);
  std::vector<std::vector<Eigen::Index>> result;
  for (Eigen::Index first = 0; first < points.cols(); ++first) {
    if (isSeen[static_cast<std::size_t>(first)]) continue;
    isSeen[static_cast<std::size_t>(first)] = true;
    std::vector<Eigen::Index> cluster = {first};
    for (std::size_t next = 0; next < cluster.size(); ++next) {
      if (next % 256 == 0) progress.check();
      for (const Neighbor& near : index.within(points.col(cluster[next]), gap))
        if (!isSeen[static_cast<std::size_t>(near.index)]) {
          isSeen[static_cast<std::size_t>(near.index)] = true;
          cluster.push_back(near.index);
        }
    }
    std::ranges::sort(cluster); // the order of a search means nothing
    result.push_back(std::move(cluster));
  }
  return result;
}

/// What is told of a cluster of points of a cloud.
Finding clusterFinding(const std::vector<Eigen::Index>& points, const PointDistances& distances) {
  const PointCloud& cloud = *distances.cloud();
  Finding finding{.kind = Kind::unexplainedPoints,
                  .node = {},
                  .others = {},
                  .amount = static_cast<double>(points.size()),
                  .points = points};
  float nearest = std::numeric_limits<float>::infinity();
  for (const Eigen::Index point : points) {
    const auto k = static_cast<std::size_t>(point);
    finding.place += cloud.position(point) / static_cast<double>(points.size());
    if (distances.toSurface()[k] >= nearest) continue;
    nearest = distances.toSurface()[k];
    finding.node = distances.nearest()[k];
  }
  for (const Eigen::Index point : points)
    finding.reach = std::max(finding.reach, (cloud.position(point) - finding.place).norm());
  return finding;
}

/// Whether points are within `reach` [L] of the surface of a frustum along half of it at least,
/// looked for in steps. pre: step > 0
bool hasPoints(const Frustum& body, const PointCloud& cloud, const SpatialIndex& index,
               double reach, double step) {
  constexpr double most = 1000; // steps: one edge across a plant of many points
  const double steps = std::clamp(std::ceil(body.length() / step), 1.0, most);
  double found = 0;
  for (double i = 0; i <= steps; ++i) {
    const double share = i / steps;
    const Eigen::Vector3f place = (body.at(share) - cloud.origin()).cast<float>();
    const auto radius = static_cast<float>(body.radiusAt(share) + reach);
    if (index.nearestOne(place, radius)) ++found;
  }
  return 2 * found >= steps + 1;
}

} // namespace

std::vector<Finding> unexplainedClusters(const PointDistances& distances, double spacing,
                                         const CheckOptions& options, const Progress& progress) {
  std::vector<Eigen::Index> far; // each place once
  const Eigen::Matrix3Xf& all = distances.cloud()->positions();
  for (std::size_t i = 0; i < distances.toSurface().size(); ++i) {
    const float distance = distances.toSurface()[i];
    const auto point = static_cast<Eigen::Index>(i);
    if (!std::isfinite(distance) || !(distance > options.pointReach * spacing)) continue;
    if (far.empty() || all.col(far.back()) != all.col(point)) far.push_back(point);
  }
  const Eigen::Matrix3Xf positions = all(Eigen::all, far);
  std::vector<Finding> findings;
  const auto gap = static_cast<float>(options.clusterGap * spacing);
  for (std::vector<Eigen::Index>& cluster : clusters(positions, gap, progress)) {
    if (cluster.size() < static_cast<std::size_t>(std::max(options.clusterSize, 1))) continue;
    for (Eigen::Index& point : cluster)
      point = far[static_cast<std::size_t>(point)];
    findings.push_back(clusterFinding(cluster, distances));
  }
  std::ranges::stable_sort(findings, std::greater<>(), &Finding::amount);
  return findings;
}

std::vector<Finding> edgesWithoutPoints(const Skeleton& skeleton, const PointCloud& cloud,
                                        const SpatialIndex& index, double spacing,
                                        const CheckOptions& options, const Progress& progress) {
  if (cloud.isEmpty() || spacing <= 0) return {};
  const std::vector<NodeId> ids = skeleton.ids();
  std::vector<char> isEmpty(skeleton.idEnd(), 0); // not bool: threads write side by side
  const auto look = [&](Eigen::Index i) {
    const NodeId id = ids[static_cast<std::size_t>(i)];
    if (!skeleton[id].parent) return;
    isEmpty[indexOf(id)] =
        hasPoints(*frustumOf(skeleton, id), cloud, index, options.emptyReach * spacing, 2 * spacing)
            ? 0
            : 1;
  };
  parallelFor(static_cast<Eigen::Index>(ids.size()), look, progress, 16);
  std::vector<Finding> findings;
  std::vector<std::size_t> findingOf(skeleton.idEnd());
  for (const NodeId id : ids) {
    if (isEmpty[indexOf(id)] == 0) continue;
    const NodeId parent = *skeleton[id].parent;
    const bool goesOn = isEmpty[indexOf(parent)] != 0;
    findingOf[indexOf(id)] = goesOn ? findingOf[indexOf(parent)] : findings.size();
    if (goesOn)
      findings[findingOf[indexOf(id)]].others.push_back(id);
    else
      findings.push_back({.kind = Kind::edgesWithoutPoints, .node = id});
    findings[findingOf[indexOf(id)]].amount +=
        (skeleton[id].position - skeleton[parent].position).norm();
  }
  return findings;
}

} // namespace espalier
