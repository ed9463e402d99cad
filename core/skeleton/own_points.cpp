#include "core/skeleton/own_points.h"

#include "core/skeleton/axes.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace espalier {

OwnPoints::OwnPoints(const Skeleton& skeleton, const PointDistances& distances,
                     const SpatialIndex& index, double spacing, const CheckOptions& options)
    : skeleton_(skeleton), distances_(distances), index_(index), spacing_(spacing),
      options_(options), wood_(bodiesOf(skeleton)), rank_(skeleton.idEnd(), 0),
      end_(skeleton.idEnd(), 0) {
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

bool OwnPoints::isBeside(NodeId branch, const Eigen::Vector3d& place) const {
  const auto isOther = [&](NodeId id) { return !carries(branch, id); };
  return wood_.distanceToSurface(place, isOther) <= options_.ownBeside * spacing_;
}

bool OwnPoints::isSeen(NodeId branch, const Eigen::Vector3d& place, double radius) const {
  const PointCloud& cloud = *distances_.cloud();
  int count = 0;
  const auto isEnough = [&](Eigen::Index point) {
    return carries(branch, distances_.nearest()[static_cast<std::size_t>(point)]) &&
           !isBeside(branch, cloud.position(point)) && ++count >= options_.ownCount;
  };
  const auto reach = static_cast<float>(radius + options_.ownReach * spacing_);
  return index_.nearestIf((place - cloud.origin()).cast<float>(), reach, isEnough).has_value();
}

std::optional<Finding> OwnPoints::missing(NodeId branch) const {
  Finding finding{.kind = Finding::Kind::noOwnPoints, .node = branch};
  bool isOver = false;
  for (std::optional<NodeId> at = branch; at && !isOver; at = nextOnAxis(skeleton_, *at)) {
    if (*at != branch) finding.others.push_back(*at);
    const Frustum body = *frustumOf(skeleton_, *at);
    constexpr double most = 1000; // steps: one edge across a plant of many points
    const double steps = std::clamp(std::ceil(body.length() / spacing_), 1.0, most);
    for (double i = 1; i <= steps && !isOver; ++i) {
      const Eigen::Vector3d place = body.at(i / steps);
      if (isBeside(branch, place)) continue;
      isOver = isSeen(branch, place, body.radiusAt(i / steps));
      if (!isOver) finding.amount += body.length() / steps;
    }
  }
  const bool isReported = finding.amount > options_.ownLength * spacing_;
  return isReported ? std::optional(std::move(finding)) : std::nullopt;
}

} // namespace espalier
