#include "core/skeleton/recenter.h"

#include "core/base/circle_fit.h"
#include "core/base/parallel.h"
#include "core/skeleton/assign_points.h"
#include "core/skeleton/smooth_axes.h"

#include <Eigen/Geometry>

#include <cmath>
#include <optional>
#include <vector>

namespace espalier {
namespace {

std::optional<NodeId> successorOf(const Skeleton& skeleton, NodeId id) {
  const std::vector<NodeId>& children = skeleton.children(id);
  if (children.empty() || skeleton[children.front()].edge != EdgeType::successor)
    return std::nullopt;
  return children.front();
}

/// Direction of the axis at a node; none for a node alone.
std::optional<Eigen::Vector3d> axisAt(const Skeleton& skeleton, NodeId id) {
  const std::optional<NodeId> below = skeleton[id].parent;
  const std::optional<NodeId> above = successorOf(skeleton, id);
  const Eigen::Vector3d& from = skeleton[below.value_or(id)].position;
  const Eigen::Vector3d& to = skeleton[above.value_or(id)].position;
  const double length = (to - from).norm();
  if (length == 0) return std::nullopt;
  return (to - from) / length;
}

/// The points around each node: those nearest to its half of an edge, by id.
std::vector<std::vector<Eigen::Index>> pointsAround(const Skeleton& skeleton,
                                                    const std::vector<PointOnSkeleton>& places) {
  std::vector<std::vector<Eigen::Index>> result(skeleton.idEnd());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const PointOnSkeleton& place = places[i];
    const Node& child = skeleton[place.child];
    const bool isLower = place.fraction < 0.5 && child.parent;
    if (isLower && child.edge == EdgeType::branching) continue; // not wood of the parent's axis
    const NodeId node = isLower ? *child.parent : place.child;
    result[indexOf(node)].push_back(static_cast<Eigen::Index>(i));
  }
  return result;
}

/// The middle of the wood around a node.
struct Middle {
  Eigen::Vector3d place = Eigen::Vector3d::Zero(); // [L]
  double radius = 0;                               // [L]
};

/// Where the axis of the wood around a node is, across `axis`; none if that cannot be trusted.
std::optional<Middle> middle(const Eigen::Vector3d& position, const Eigen::Vector3d& axis,
                             const std::vector<Eigen::Vector3d>& points,
                             const RecenterOptions& options) {
  constexpr std::size_t fewest = 8; // for a circle to mean something
  if (points.size() < fewest) return std::nullopt;
  const Eigen::Vector3d right = axis.unitOrthogonal();
  const Eigen::Vector3d up = axis.cross(right);
  std::vector<Eigen::Vector2d> section;
  section.reserve(points.size());
  for (const Eigen::Vector3d& point : points)
    section.emplace_back((point - position).dot(right), (point - position).dot(up));
  const auto circle = fitCircle(section);
  constexpr double mostError = 0.3; // in radii: more of it is no circle
  if (!circle || circle->coverage < options.leastCoverage ||
      circle->error > mostError * circle->radius)
    return std::nullopt;
  return Middle{position + circle->center.x() * right + circle->center.y() * up, circle->radius};
}

/// Moves nodes without a middle of their own between two that have one onto the line between these,
/// if they are near enough on the axis: branches that stand off there have pulled them aside.
void straighten(Skeleton& skeleton, const std::vector<NodeId>& ids,
                const std::vector<std::optional<Middle>>& middles, double reach) {
  std::vector<NodeId> between;
  for (const NodeId first : ids) {
    if (!middles[indexOf(first)]) continue;
    between.clear();
    double length = 0;
    NodeId at = first;
    while (const std::optional<NodeId> next = successorOf(skeleton, at)) {
      length += (skeleton[*next].position - skeleton[at].position).norm();
      at = *next;
      if (middles[indexOf(at)]) break;
      between.push_back(at);
    }
    if (between.empty() || !middles[indexOf(at)]) continue;
    const Middle& below = *middles[indexOf(first)];
    const Middle& above = *middles[indexOf(at)];
    if (length > reach * std::min(below.radius, above.radius)) continue;
    const Eigen::Vector3d line = (above.place - below.place).normalized();
    for (const NodeId id : between) {
      const Eigen::Vector3d from = skeleton[id].position - below.place;
      skeleton.setPosition(id, below.place + from.dot(line) * line);
    }
  }
}

} // namespace

Skeleton recentered(const Skeleton& skeleton, const Eigen::Matrix3Xf& points,
                    const Eigen::Vector3d& origin, const RecenterOptions& options,
                    const Progress& progress) {
  Skeleton result = skeleton;
  if (skeleton.isEmpty() || points.cols() == 0) return result;
  const std::vector<NodeId> ids = skeleton.ids();
  for (int round = 0; round < options.rounds; ++round) {
    const Progress part = progress.part(static_cast<double>(round) / options.rounds,
                                        static_cast<double>(round + 1) / options.rounds);
    const auto around =
        pointsAround(result, assignPoints(points, origin, result, part.part(0, 0.7)));
    std::vector<std::optional<Middle>> middles(skeleton.idEnd());
    const auto place = [&](Eigen::Index i) {
      const NodeId id = ids[static_cast<std::size_t>(i)];
      const auto axis = axisAt(result, id);
      const std::vector<Eigen::Index>& own = around[indexOf(id)];
      if (!axis || own.empty()) return;
      std::vector<Eigen::Vector3d> near;
      near.reserve(own.size());
      for (const Eigen::Index point : own)
        near.emplace_back(points.col(point).cast<double>() + origin);
      middles[indexOf(id)] = middle(result[id].position, *axis, near, options);
    };
    parallelFor(static_cast<Eigen::Index>(ids.size()), place, part.part(0.7, 1), 64);
    for (const NodeId id : ids)
      if (middles[indexOf(id)]) result.setPosition(id, middles[indexOf(id)]->place);
    straighten(result, ids, middles, options.straightReach);
    result = withSmoothAxes(result, options.smoothing);
  }
  return result;
}

std::optional<Eigen::Vector3d> sectionCenter(const Skeleton& skeleton, NodeId id,
                                             const std::vector<Eigen::Vector3d>& near,
                                             const RecenterOptions& options) {
  const std::optional<Eigen::Vector3d> axis = axisAt(skeleton, id);
  if (!axis) return std::nullopt;
  const Eigen::Vector3d& place = skeleton[id].position;
  const auto half = [&](std::optional<NodeId> neighbor) {
    return neighbor ? std::abs((skeleton[*neighbor].position - place).dot(*axis)) / 2 : 0.0;
  };
  const double before = half(skeleton[id].parent);
  const double behind = half(successorOf(skeleton, id));
  std::vector<Eigen::Vector3d> slab;
  for (const Eigen::Vector3d& point : near) {
    const double along = (point - place).dot(*axis);
    if (along >= -before && along <= behind) slab.push_back(point);
  }
  const std::optional<Middle> found = middle(place, *axis, slab, options);
  return found ? std::optional(found->place) : std::nullopt;
}

} // namespace espalier
