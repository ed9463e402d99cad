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

/// Where the axis of the wood around a node is, across `axis`; none if that cannot be trusted.
std::optional<Eigen::Vector3d> middle(const Eigen::Vector3d& position, const Eigen::Vector3d& axis,
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
  return position + circle->center.x() * right + circle->center.y() * up;
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
        pointsAround(result, assignPoints(points, origin, result, 8, part.part(0, 0.7)));
    std::vector<Eigen::Vector3d> positions(skeleton.idEnd());
    const auto place = [&](Eigen::Index i) {
      const NodeId id = ids[static_cast<std::size_t>(i)];
      positions[indexOf(id)] = result[id].position;
      const auto axis = axisAt(result, id);
      const std::vector<Eigen::Index>& own = around[indexOf(id)];
      if (!axis || own.empty()) return;
      std::vector<Eigen::Vector3d> near;
      near.reserve(own.size());
      for (const Eigen::Index point : own)
        near.emplace_back(points.col(point).cast<double>() + origin);
      positions[indexOf(id)] =
          middle(result[id].position, *axis, near, options).value_or(result[id].position);
    };
    parallelFor(static_cast<Eigen::Index>(ids.size()), place, part.part(0.7, 1), 64);
    for (const NodeId id : ids)
      result.setPosition(id, positions[indexOf(id)]);
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
  return middle(place, *axis, slab, options);
}

} // namespace espalier
