#include "core/skeleton/own_points.h"

#include "core/base/parallel.h"
#include "core/skeleton/axes.h"
#include "core/skeleton/edge_index.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace espalier {
namespace {

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

  /// The stretch at the beginning of a branch, if it is worth telling.
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
    const bool isTold = finding.amount > options.ownLength * spacing;
    return isTold ? std::optional(std::move(finding)) : std::nullopt;
  }
};

} // namespace

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
