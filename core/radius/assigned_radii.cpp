#include "core/radius/assigned_radii.h"

#include "core/radius/section_circle.h"
#include "core/skeleton/assign_points.h"
#include "core/skeleton/axes.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace espalier {
namespace {

constexpr std::size_t fewestPoints = 3;

NodeId ownerOf(const Skeleton& skeleton, const PointOnSkeleton& place) {
  const Node& child = skeleton[place.child];
  const bool isLower = place.fraction < 0.5 && child.parent && child.edge == EdgeType::successor;
  return isLower ? *child.parent : place.child;
}

/// Direction of the wood at a node; upright for a node alone.
Eigen::Vector3d axisAt(const Skeleton& skeleton, NodeId id) {
  const Node& node = skeleton[id];
  const NodeId above = nextOnAxis(skeleton, id).value_or(id);
  const NodeId below = node.parent.value_or(id);
  const Eigen::Vector3d along = skeleton[above].position - skeleton[below].position;
  const double length = along.norm();
  return length > 0 ? Eigen::Vector3d(along / length) : Eigen::Vector3d::UnitZ();
}

double meanOf(const AssignedPoints& points, std::span<const std::uint32_t> own) {
  double sum = 0;
  for (const std::uint32_t column : own)
    sum += points.distance(column);
  return sum / static_cast<double>(own.size());
}

double maximumOf(const AssignedPoints& points, std::span<const std::uint32_t> own) {
  std::vector<double> distances;
  for (const std::uint32_t column : own)
    distances.push_back(points.distance(column));
  const auto place = static_cast<std::ptrdiff_t>((distances.size() - 1) * 95 / 100);
  std::nth_element(distances.begin(), distances.begin() + place, distances.end());
  return distances[static_cast<std::size_t>(place)];
}

double hullOf(const Skeleton& skeleton, NodeId id, const AssignedPoints& points,
              std::span<const std::uint32_t> own) {
  const Eigen::Vector3d axis = axisAt(skeleton, id);
  const Eigen::Vector3d right = axis.unitOrthogonal();
  const Eigen::Vector3d up = axis.cross(right);
  std::vector<Eigen::Vector2d> across;
  for (const std::uint32_t column : own) {
    const Eigen::Vector3d d = points.position(column) - skeleton[id].position;
    across.emplace_back(d.dot(right), d.dot(up));
  }
  const std::optional<FittedCircle> circle = hullCircle(across);
  return circle ? circle->radius : 0;
}

} // namespace

AssignedPoints::AssignedPoints(const Skeleton& skeleton, const Eigen::Matrix3Xf& points,
                               const Eigen::Vector3d& origin, const Progress& progress)
    : points_(points), origin_(origin), begin_(skeleton.idEnd() + 1, 0) {
  if (skeleton.isEmpty()) return;
  const std::vector<PointOnSkeleton> places = assignPoints(points, origin, skeleton, progress);
  std::vector<NodeId> owners;
  owners.reserve(places.size());
  distances_.reserve(places.size());
  for (const PointOnSkeleton& place : places) {
    owners.push_back(ownerOf(skeleton, place));
    distances_.push_back(place.distance);
    ++begin_[indexOf(owners.back()) + 1];
  }
  for (std::size_t i = 1; i < begin_.size(); ++i)
    begin_[i] += begin_[i - 1];
  columns_.resize(places.size());
  std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
  for (std::size_t i = 0; i < owners.size(); ++i)
    columns_[next[indexOf(owners[i])]++] = static_cast<std::uint32_t>(i);
}

std::vector<double> assignedRadii(const Skeleton& skeleton, const AssignedPoints& points,
                                  AssignedMeasure measure) {
  std::vector<double> radii(skeleton.idEnd(), 0);
  for (const NodeId id : skeleton.ids()) {
    const std::span<const std::uint32_t> own = points.of(id);
    if (own.size() < fewestPoints) continue;
    switch (measure) {
    case AssignedMeasure::mean:
      radii[indexOf(id)] = meanOf(points, own);
      break;
    case AssignedMeasure::maximum:
      radii[indexOf(id)] = maximumOf(points, own);
      break;
    case AssignedMeasure::hull:
      radii[indexOf(id)] = hullOf(skeleton, id, points, own);
      break;
    }
  }
  return radii;
}

namespace {

/// Fills in one axis, of which at least one radius is known.
void interpolate(const Skeleton& skeleton, const Axis& axis, std::vector<double>& radii) {
  std::vector<double> along(axis.size(), 0);
  std::vector<std::size_t> known;
  for (std::size_t i = 0; i < axis.size(); ++i) {
    if (i > 0)
      along[i] =
          along[i - 1] + (skeleton[axis[i]].position - skeleton[axis[i - 1]].position).norm();
    if (radii[indexOf(axis[i])] > 0) known.push_back(i);
  }
  std::size_t next = 0; // of `known`, the first not below i
  for (std::size_t i = 0; i < axis.size(); ++i) {
    while (next < known.size() && known[next] < i)
      ++next;
    const std::size_t above = known[std::min(next, known.size() - 1)];
    const std::size_t below = next < known.size() && known[next] == i ? i
                              : next > 0                              ? known[next - 1]
                                                                      : above;
    const double gap = along[above] - along[below];
    const double share = gap > 0 ? std::clamp((along[i] - along[below]) / gap, 0.0, 1.0) : 0;
    radii[indexOf(axis[i])] =
        (1 - share) * radii[indexOf(axis[below])] + share * radii[indexOf(axis[above])];
  }
}

bool isKnown(const Axis& axis, const std::vector<double>& radii) {
  return std::ranges::any_of(axis, [&](NodeId id) { return radii[indexOf(id)] > 0; });
}

} // namespace

std::vector<double> interpolatedRadii(const Skeleton& skeleton, std::vector<double> radii) {
  const std::vector<Axis> all = axes(skeleton);
  for (const Axis& axis : all)
    if (isKnown(axis, radii)) interpolate(skeleton, axis, radii);
  // From the tips down: an axis without any takes what the thickest of its branches has.
  const std::vector<NodeId> ids = skeleton.ids();
  std::vector<double> carried = radii;
  for (auto id = ids.rbegin(); id != ids.rend(); ++id)
    if (const auto parent = skeleton[*id].parent)
      if (radii[indexOf(*parent)] == 0)
        carried[indexOf(*parent)] = std::max(carried[indexOf(*parent)], carried[indexOf(*id)]);
  for (const NodeId id : ids) {
    if (radii[indexOf(id)] > 0) continue;
    const auto parent = skeleton[id].parent;
    radii[indexOf(id)] = parent ? radii[indexOf(*parent)] : carried[indexOf(id)];
  }
  return radii;
}

std::vector<double> meanPointDistances(const Skeleton& skeleton, const Eigen::Matrix3Xf& points,
                                       const Eigen::Vector3d& origin, const Progress& progress) {
  std::vector<double> sums(skeleton.idEnd(), 0);
  if (skeleton.isEmpty()) return sums;
  std::vector<double> counts(skeleton.idEnd(), 0);
  for (const PointOnSkeleton& place : assignPoints(points, origin, skeleton, progress)) {
    // Unlike ownerOf(): the lower half of a branch's first edge is of the wood that bears it, too.
    const bool isLower = place.fraction < 0.5 && skeleton[place.child].parent;
    const NodeId node = isLower ? *skeleton[place.child].parent : place.child;
    sums[indexOf(node)] += place.distance;
    counts[indexOf(node)] += 1;
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (counts[i] > 0) sums[i] /= counts[i];
  return sums;
}

} // namespace espalier
