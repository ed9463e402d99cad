#include "core/skeleton/checks_of_scan.h"

#include "core/base/parallel.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/edge_index.h"

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

/// All wood of a skeleton, and what lies beyond a branch.
class Wood {
public:
  explicit Wood(const Skeleton& skeleton)
      : index_(bodiesOf(skeleton)), rank_(skeleton.idEnd(), 0), end_(skeleton.idEnd(), 0) {
    number(skeleton);
  }

  /// Does `branch` carry `id`, or is it the same?
  [[nodiscard]] bool carries(NodeId branch, NodeId id) const {
    const std::size_t rank = rank_[indexOf(id)];
    return rank >= rank_[indexOf(branch)] && rank < end_[indexOf(branch)];
  }

  /// From a place to the surface of the nearest wood that `branch` does not carry, 0 inside [L].
  [[nodiscard]] double distanceBeside(NodeId branch, const Eigen::Vector3d& place) const {
    return index_.distanceToSurface(place, [&](NodeId id) { return !carries(branch, id); });
  }

private:
  /// Ranks in depth-first order, so that what a node carries is one run of them.
  void number(const Skeleton& skeleton) {
    std::vector<NodeId> open = skeleton.roots();
    std::vector<NodeId> order; // parents before their children
    while (!open.empty()) {
      const NodeId id = open.back();
      open.pop_back();
      rank_[indexOf(id)] = order.size();
      order.push_back(id);
      end_[indexOf(id)] = order.size();
      open.insert(open.end(), skeleton.children(id).begin(), skeleton.children(id).end());
    }
    for (auto id = order.rbegin(); id != order.rend(); ++id)
      if (const auto parent = skeleton[*id].parent)
        end_[indexOf(*parent)] = std::max(end_[indexOf(*parent)], end_[indexOf(*id)]);
  }

  EdgeIndex index_;
  std::vector<std::size_t> rank_, end_; // by id
};

/// What branches are checked with.
struct Check {
  const Skeleton& skeleton;
  const PointDistances& distances;
  const SpatialIndex& index;
  const Wood& wood;
  double spacing; // [L]
  const CheckOptions& options;

  [[nodiscard]] bool isBeside(NodeId branch, const Eigen::Vector3d& place) const {
    return wood.distanceBeside(branch, place) <= options.ownBeside * spacing;
  }

  [[nodiscard]] bool hasOwnPoints(NodeId branch, const Eigen::Vector3d& place,
                                  double radius) const {
    const PointCloud& cloud = *distances.cloud();
    int count = 0;
    const auto isEnough = [&](Eigen::Index point) {
      return wood.carries(branch, distances.nearest()[static_cast<std::size_t>(point)]) &&
             !isBeside(branch, cloud.position(point)) && ++count >= options.ownCount;
    };
    const auto reach = static_cast<float>(radius + options.ownReach * spacing);
    return index.nearestIf((place - cloud.origin()).cast<float>(), reach, isEnough).has_value();
  }

  /// The stretch at the beginning of a branch, if it is worth reporting.
  [[nodiscard]] std::optional<Finding> look(NodeId branch) const {
    Finding finding{.kind = Finding::Kind::noOwnPoints, .node = branch};
    bool isOver = false;
    for (std::optional<NodeId> at = branch; at && !isOver; at = nextOnAxis(skeleton, *at)) {
      if (*at != branch) finding.others.push_back(*at);
      const Frustum body = *frustumOf(skeleton, *at);
      constexpr double most = 1000; // steps: one edge across a plant of many points
      const double steps = std::clamp(std::ceil(body.length() / spacing), 1.0, most);
      for (double i = 1; i <= steps && !isOver; ++i) {
        const Eigen::Vector3d place = body.at(i / steps);
        if (isBeside(branch, place)) continue;
        isOver = hasOwnPoints(branch, place, body.radiusAt(i / steps));
        if (!isOver) finding.amount += body.length() / steps;
      }
    }
    const bool isReported = finding.amount > options.ownLength * spacing;
    return isReported ? std::optional(std::move(finding)) : std::nullopt;
  }
};

void append(std::vector<Finding>& all, std::vector<Finding> more) {
  std::ranges::move(more, std::back_inserter(all));
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
  append(all, unexplainedClusters(distances, spacing, options, progress));
  return all;
}

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

std::vector<Finding> branchesWithoutOwnPoints(const Skeleton& skeleton,
                                              const PointDistances& distances,
                                              const SpatialIndex& index, double spacing,
                                              const CheckOptions& options,
                                              const Progress& progress) {
  if (distances.cloud()->isEmpty() || skeleton.isEmpty() || spacing <= 0) return {};
  const Wood wood(skeleton);
  const Check check{skeleton, distances, index, wood, spacing, options};
  std::vector<NodeId> branches;
  for (const NodeId id : skeleton.ids()) {
    const auto parent = skeleton[id].parent;
    if (parent && nextOnAxis(skeleton, *parent) != id) branches.push_back(id);
  }
  std::vector<std::optional<Finding>> found(branches.size());
  const auto look = [&](Eigen::Index i) {
    found[static_cast<std::size_t>(i)] = check.look(branches[static_cast<std::size_t>(i)]);
  };
  parallelFor(static_cast<Eigen::Index>(branches.size()), look, progress, 16);
  std::vector<Finding> findings;
  for (std::optional<Finding>& one : found)
    if (one) findings.push_back(std::move(*one));
  return findings;
}

} // namespace espalier
