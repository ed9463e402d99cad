#include "core/skeleton/checks_of_scan.h"

#include "core/base/parallel.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/beside_points.h"
#include "core/skeleton/blades_along.h"
#include "core/skeleton/frustum.h"
#include "core/skeleton/own_points.h"
#include "core/skeleton/short_foot.h"
#include "core/skeleton/unseen_wood.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <utility>

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

/// What is reported of a cluster of points of a cloud.
Finding clusterFinding(const std::vector<Eigen::Index>& points, const PointDistances& distances) {
  Finding finding{.kind = Kind::unexplainedPoints,
                  .node = {},
                  .others = {},
                  .amount = static_cast<double>(points.size()),
                  .points = points};
  float nearest = std::numeric_limits<float>::infinity();
  for (const Eigen::Index point : points) {
    const auto k = static_cast<std::size_t>(point);
    if (distances.toSurface()[k] >= nearest) continue;
    nearest = distances.toSurface()[k];
    finding.node = distances.nearest()[k];
  }
  place(finding, *distances.cloud());
  return finding;
}

/// The connected parts of points that are off all wood, where they stand out.
std::vector<Finding> clusterFindings(const std::vector<Eigen::Index>& far,
                                     const PointDistances& distances, double reach, double spacing,
                                     const CheckOptions& options, const Progress& progress) {
  const Eigen::Matrix3Xf positions = distances.cloud()->positions()(Eigen::all, far);
  std::vector<Finding> findings;
  const auto gap = static_cast<float>(options.clusterGap * spacing);
  for (std::vector<Eigen::Index>& cluster : clusters(positions, gap, progress)) {
    if (cluster.size() < static_cast<std::size_t>(std::max(options.clusterSize, 1))) continue;
    double farthest = 0;
    for (Eigen::Index& point : cluster) {
      point = far[static_cast<std::size_t>(point)];
      farthest = std::max<double>(farthest, distances.toSurface()[static_cast<std::size_t>(point)]);
    }
    if (farthest < options.clusterRise * reach &&
        static_cast<int>(cluster.size()) < options.largeCluster)
      continue;
    findings.push_back(clusterFinding(cluster, distances));
  }
  return findings;
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

void append(std::vector<Finding>& all, std::vector<Finding> more) {
  std::ranges::move(more, std::back_inserter(all));
}

/// Whether most points of a cluster are there because wood lies beside them, or a foot is short.
bool explains(const Finding& other, const Finding& cluster, const PointDistances& distances) {
  if (other.kind != Kind::besidePoints && other.kind != Kind::shortFoot) return false;
  const std::vector<NodeId> nodes = nodesOf(other);
  const auto count = std::ranges::count_if(cluster.points, [&](Eigen::Index point) {
    if (other.kind == Kind::shortFoot) return std::ranges::binary_search(other.points, point);
    const NodeId nearest = distances.nearest()[static_cast<std::size_t>(point)];
    return std::ranges::find(nodes, nearest) != nodes.end();
  });
  return 2 * count > static_cast<std::ptrdiff_t>(cluster.points.size());
}

/// Leaves out those at a node that another finding is at.
void eraseReported(std::vector<Finding>& findings, const std::vector<Finding>& others) {
  std::set<NodeId> reported;
  for (const Finding& finding : others)
    std::ranges::copy(nodesOf(finding), std::inserter(reported, reported.end()));
  std::erase_if(findings, [&](const Finding& finding) {
    return std::ranges::any_of(nodesOf(finding), [&](NodeId id) { return reported.contains(id); });
  });
}

/// What is left of clusters without the blades along axes.
std::vector<Finding> clustersOffBlades(const std::vector<Finding>& clusters,
                                       const Skeleton& skeleton, const PointDistances& distances,
                                       double reach, double spacing, const CheckOptions& options,
                                       const Progress& progress) {
  std::vector<Finding> left;
  for (const Finding& cluster : clusters) {
    progress.check();
    const std::vector<Eigen::Index> rest =
        pointsOffBlades(skeleton, cluster.points, distances, reach, spacing);
    if (rest.size() == cluster.points.size())
      left.push_back(cluster);
    else // in parts, each of which may be another blade
      append(left,
             clustersOffBlades(clusterFindings(rest, distances, reach, spacing, options, progress),
                               skeleton, distances, reach, spacing, options, progress));
  }
  std::ranges::stable_sort(left, std::greater<>(), &Finding::amount);
  return left;
}

/// What points show that are off all wood: wood that lies beside its points, short feet, and
/// clusters of points that neither explains.
std::vector<Finding> checkPointsOffWood(const Skeleton& skeleton, const PointDistances& distances,
                                        double spacing, const CheckOptions& options,
                                        const Progress& progress) {
  const double unit = exactness(distances, spacing, options);
  std::vector<Finding> all =
      axesBesidePoints(skeleton, distances, spacing, unit, options, progress);
  append(all, shortFeet(skeleton, distances, spacing, options, progress));
  std::vector<Finding> clusters = unexplainedClusters(distances, spacing, options, progress);
  std::erase_if(clusters, [&](const Finding& cluster) {
    return std::ranges::any_of(
        all, [&](const Finding& other) { return explains(other, cluster, distances); });
  });
  append(all, clustersOffBlades(clusters, skeleton, distances, options.pointReach * unit, spacing,
                                options, progress));
  return all;
}

} // namespace

std::vector<Finding> checkAgainstScan(const Skeleton& skeleton, const PointDistances& distances,
                                      const SpatialIndex& index, double spacing,
                                      const CheckOptions& options, const Progress& progress) {
  std::vector<Finding> all =
      edgesWithoutPoints(skeleton, *distances.cloud(), index, spacing, options, progress);
  std::vector<Finding> own =
      branchesWithoutOwnPoints(skeleton, distances, index, spacing, options, progress);
  eraseReported(own, all);
  append(all, std::move(own));
  const UnseenWood unseen(skeleton, distances, index, spacing, options);
  std::erase_if(all, [&](const Finding& finding) { return unseen.mayBeHidden(finding); });
  append(all, checkPointsOffWood(skeleton, distances, spacing, options, progress));
  return all;
}

std::vector<Finding> pointsWithoutWood(const Skeleton& skeleton, const PointDistances& distances,
                                       double spacing, const CheckOptions& options,
                                       const Progress& progress) {
  std::vector<Finding> found = checkPointsOffWood(skeleton, distances, spacing, options, progress);
  std::erase_if(found,
                [](const Finding& finding) { return finding.kind != Kind::unexplainedPoints; });
  return found;
}

double exactness(const PointDistances& distances, double spacing, const CheckOptions& options) {
  const double least = std::max(1.0, options.scatter) * spacing;
  constexpr double farthest = 6; // what is farther off is missing, and says nothing of the rest
  std::vector<float> off;
  for (const float distance : distances.toSurface())
    if (std::abs(distance) <= farthest * least) off.push_back(std::abs(distance));
  if (off.empty()) return least;
  const auto middle = off.begin() + static_cast<std::ptrdiff_t>(off.size() / 2);
  std::ranges::nth_element(off, middle);
  return std::clamp(4.0 / 3 * *middle, least, 2 * least);
}

std::vector<Finding> unexplainedClusters(const PointDistances& distances, double spacing,
                                         const CheckOptions& options, const Progress& progress) {
  std::vector<Eigen::Index> far; // each place once
  const double reach = options.pointReach * exactness(distances, spacing, options);
  const Eigen::Matrix3Xf& all = distances.cloud()->positions();
  for (std::size_t i = 0; i < distances.toSurface().size(); ++i) {
    const float distance = distances.toSurface()[i];
    const auto point = static_cast<Eigen::Index>(i);
    if (!std::isfinite(distance) || !(distance > reach)) continue;
    if (far.empty() || all.col(far.back()) != all.col(point)) far.push_back(point);
  }
  std::vector<Finding> findings =
      clusterFindings(far, distances, reach, spacing, options, progress);
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

std::vector<Finding> branchesWithoutOwnPoints(const Skeleton& skeleton,
                                              const PointDistances& distances,
                                              const SpatialIndex& index, double spacing,
                                              const CheckOptions& options,
                                              const Progress& progress) {
  if (distances.cloud()->isEmpty() || skeleton.isEmpty() || spacing <= 0) return {};
  const OwnPoints own(skeleton, distances, index, spacing, options);
  std::vector<NodeId> branches;
  for (const NodeId id : skeleton.ids()) {
    const auto parent = skeleton[id].parent;
    if (parent && nextOnAxis(skeleton, *parent) != id) branches.push_back(id);
  }
  std::vector<std::optional<Finding>> found(branches.size());
  const auto look = [&](Eigen::Index i) {
    found[static_cast<std::size_t>(i)] = own.missing(branches[static_cast<std::size_t>(i)]);
  };
  parallelFor(static_cast<Eigen::Index>(branches.size()), look, progress, 16);
  std::vector<Finding> findings;
  for (std::optional<Finding>& one : found)
    if (one) findings.push_back(std::move(*one));
  return findings;
}

} // namespace espalier
