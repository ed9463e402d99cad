#include "core/radius/cross_section.h"

#include "core/skeleton/axes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace espalier {
namespace {

double distanceTo(const Eigen::Vector3d& start, const Eigen::Vector3d& along,
                  const Eigen::Vector3d& place) {
  const double squaredLength = along.squaredNorm();
  const double fraction =
      squaredLength > 0 ? std::clamp((place - start).dot(along) / squaredLength, 0.0, 1.0) : 0.0;
  return (place - start - fraction * along).norm();
}

/// A frame across `axis`, without points.
CrossSection frameAcross(const Eigen::Vector3d& axis, const Eigen::Vector3d& center) {
  constexpr double upright = 0.9; // cosine to z
  const Eigen::Vector3d toward =
      std::abs(axis.z()) < upright ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d::UnitY();
  const Eigen::Vector3d up = (toward - toward.dot(axis) * axis).normalized();
  return {.center = center,
          .right = up.cross(axis),
          .up = up,
          .halfThickness = 0,
          .points = {},
          .others = {}};
}

} // namespace

/// A point in the slab of a section.
struct CrossSections::Sighting {
  Eigen::Vector2d at;
  double distance; // from the node, across the axis [L]
  bool isOwn;
};

CrossSections::CrossSections(const Skeleton& skeleton, const IndexedPoints& points)
    : skeleton_(skeleton), points_(points), axisOf_(skeleton.idEnd(), 0) {
  std::uint32_t number = 0;
  for (const Axis& axis : axes(skeleton)) {
    for (const NodeId id : axis) {
      axisOf_[indexOf(id)] = number;
      if (skeleton[id].parent) children_.push_back(id);
    }
    ++number;
  }
  middles_.resize(3, static_cast<Eigen::Index>(children_.size()));
  for (std::size_t i = 0; i < children_.size(); ++i) {
    const Node& node = skeleton[children_[i]];
    const Eigen::Vector3d start = skeleton[*node.parent].position;
    middles_.col(static_cast<Eigen::Index>(i)) =
        ((start + node.position) / 2 - points.origin).cast<float>();
    longest_ = std::max(longest_, (node.position - start).norm() / 2);
  }
  if (!children_.empty()) edges_.emplace(middles_);
}

/// The radius of the wood about a node [L]: one wrong number among three does not count. 0 if none
/// is known.
double CrossSections::radiusAbout(NodeId id) const {
  std::vector<double> known;
  const auto note = [&](NodeId node) {
    if (skeleton_[node].radius > 0) known.push_back(skeleton_[node].radius);
  };
  note(id);
  const std::optional<NodeId>& parent = skeleton_[id].parent;
  if (parent && axisOf_[indexOf(*parent)] == axisOf_[indexOf(id)]) note(*parent);
  if (const std::optional<NodeId> next = nextOnAxis(skeleton_, id)) note(*next);
  if (known.empty()) return 0;
  std::ranges::sort(known);
  return known[(known.size() - 1) / 2];
}

/// The direction of the wood at a node, towards its tip, over about `reach` on either side.
std::optional<Eigen::Vector3d> CrossSections::axisAt(NodeId id, double reach) const {
  const Eigen::Vector3d& center = skeleton_[id].position;
  const auto isFar = [&](NodeId node) {
    return (skeleton_[node].position - center).norm() >= reach;
  };
  NodeId below = id;
  while (skeleton_[below].parent && (below == id || !isFar(below))) {
    const bool ends = axisOf_[indexOf(*skeleton_[below].parent)] != axisOf_[indexOf(id)];
    below = *skeleton_[below].parent;
    if (ends) break; // on the axis that bears this one
  }
  NodeId above = id;
  for (auto next = nextOnAxis(skeleton_, id); next && (above == id || !isFar(above));
       next = nextOnAxis(skeleton_, *next))
    above = *next;
  if (below == above && !skeleton_.children(id).empty()) above = skeleton_.children(id).front();
  const Eigen::Vector3d along = skeleton_[above].position - skeleton_[below].position;
  const double length = along.norm();
  if (!(length > 0)) return std::nullopt;
  return along / length;
}

/// The edges that points within `reach` of a node may belong to.
std::vector<CrossSections::Edge> CrossSections::edgesAbout(NodeId id, double radius,
                                                           double reach) const {
  constexpr double thinnest = 0.25; // of radii; a wrong radius must not take all points, or none
  constexpr double thickest = 2;
  constexpr double unknown = 0.5;
  const Eigen::Vector3d& center = skeleton_[id].position;
  const std::uint32_t own = axisOf_[indexOf(id)];
  const double farthest = (1 + thickest) * reach;
  const Eigen::Vector3f local = (center - points_.origin).cast<float>();
  std::vector<Edge> result;
  for (const Neighbor& near : edges_->within(local, static_cast<float>(farthest + longest_))) {
    const NodeId child = children_[static_cast<std::size_t>(near.index)];
    const Node& node = skeleton_[child];
    const Eigen::Vector3d start = skeleton_[*node.parent].position;
    const Eigen::Vector3d along = node.position - start;
    if (distanceTo(start, along, center) > farthest) continue;
    Edge edge{.start = start, .along = along, .share = 1, .isOwn = true};
    if (axisOf_[indexOf(child)] != own) {
      const bool isChild = axisOf_[indexOf(*node.parent)] == own;
      edge.isOwn = false;
      edge.share = radius > 0 && node.radius > 0
                       ? std::clamp(node.radius / radius, thinnest, thickest)
                       : (isChild ? unknown : 1);
    }
    result.push_back(edge);
  }
  return result;
}

/// The points of the slab within `reach` of the node, from the node outwards.
std::vector<CrossSections::Sighting> CrossSections::look(const CrossSection& frame, NodeId id,
                                                         double radius, double reach) const {
  const std::vector<Edge> edges = edgesAbout(id, radius, reach);
  const Eigen::Vector3d axis = frame.right.cross(frame.up);
  const auto isOwn = [&](const Eigen::Vector3d& point) {
    double own = std::numeric_limits<double>::infinity();
    double rival = std::numeric_limits<double>::infinity();
    for (const Edge& edge : edges) {
      double& nearest = edge.isOwn ? own : rival;
      nearest = std::min(nearest, distanceTo(edge.start, edge.along, point) / edge.share);
    }
    return own <= rival;
  };
  const Eigen::Vector3f local = (frame.center - points_.origin).cast<float>();
  const double ball = std::hypot(reach, frame.halfThickness);
  std::vector<std::pair<Sighting, Eigen::Index>> found;
  for (const Neighbor& near : points_.index.within(local, static_cast<float>(ball))) {
    const Eigen::Vector3d point = points_.positions.col(near.index).cast<double>() + points_.origin;
    const Eigen::Vector3d d = point - frame.center;
    if (std::abs(d.dot(axis)) > frame.halfThickness) continue;
    const Eigen::Vector2d at(d.dot(frame.right), d.dot(frame.up));
    if (at.norm() > reach) continue;
    found.push_back({{.at = at, .distance = at.norm(), .isOwn = isOwn(point)}, near.index});
  }
  std::ranges::sort(found, [](const auto& a, const auto& b) {
    return std::pair(a.first.distance, a.second) < std::pair(b.first.distance, b.second);
  });
  std::vector<Sighting> result;
  result.reserve(found.size());
  for (const auto& [sighting, index] : found)
    result.push_back(sighting);
  return result;
}

std::optional<CrossSection> CrossSections::at(NodeId id) const {
  if (!edges_ || points_.positions.cols() == 0) return std::nullopt;
  const Eigen::Vector3d center = skeleton_[id].position;
  const Eigen::Vector3f local = (center - points_.origin).cast<float>();
  const std::optional<Neighbor> found = points_.index.nearestOne(local);
  if (!found) return std::nullopt; // all of them are passed over
  const double nearest = std::sqrt(found->squaredDistance);
  const double known = radiusAbout(id);
  const double radius = known > 0 ? known : nearest;
  const std::optional<Eigen::Vector3d> axis = axisAt(id, std::max(radius, 3 * points_.spacing));
  if (!axis) return std::nullopt;
  CrossSection section = frameAcross(*axis, center);
  section.halfThickness = std::max(2.5 * points_.spacing, radius / 4);

  const auto widestGap = [&](double distance) {
    return std::max(4 * points_.spacing, distance / 4);
  };
  double reach = std::max({2 * radius, 2 * nearest, 8 * points_.spacing});
  constexpr int doublings = 3; // among leaves there is no gap
  for (int i = 0;; ++i) {
    const std::vector<Sighting> seen = look(section, id, known, reach);
    double last = std::max(nearest, 1.5 * known); // up to there gaps do not count
    for (const Sighting& each : seen)
      if (each.isOwn && each.distance <= last + widestGap(last))
        last = std::max(last, each.distance);
    if (i < doublings && last + widestGap(last) > reach) {
      reach *= 2; // wood may go on beyond what was looked at
      continue;
    }
    for (const Sighting& each : seen)
      if (!each.isOwn)
        section.others.push_back(each.at);
      else if (each.distance <= last)
        section.points.push_back(each.at);
    return section;
  }
}

} // namespace espalier
