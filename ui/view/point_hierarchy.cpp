#include "ui/view/point_hierarchy.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace espalier {
namespace {

/// A point a little deeper but nearer to the axis is meant rather than one at the rim of the cone.
constexpr float axisPreference = 4;

struct Hit {
  Eigen::Index point = -1;
  float cost = std::numeric_limits<float>::infinity();
};

float radiusAt(const ViewCone& cone, float depth) {
  return cone.radius + cone.slope * depth;
}

/// Least cost that a point of the box may have; infinite if none can be in the cone.
float leastCost(const Eigen::AlignedBox3f& box, const ViewCone& cone) {
  const Eigen::Vector3f offset = box.center() - cone.apex;
  const float reach = 0.5F * box.diagonal().norm();
  const float depth = offset.dot(cone.direction);
  const float aside = (offset - depth * cone.direction).norm();
  if (box.isEmpty() || depth + reach <= 0 || aside - reach > radiusAt(cone, depth + reach))
    return std::numeric_limits<float>::infinity();
  return std::max(0.0F, depth - reach) + axisPreference * std::max(0.0F, aside - reach);
}

void pickInRun(const Eigen::Matrix3Xf& points, Eigen::Index begin, Eigen::Index end,
               const ViewCone& cone, const std::function<bool(Eigen::Index)>& accepts, Hit& best) {
  for (Eigen::Index i = begin; i < end; ++i) {
    const Eigen::Vector3f offset = points.col(i) - cone.apex;
    const float depth = offset.dot(cone.direction);
    const float aside = (offset - depth * cone.direction).norm();
    if (depth <= 0 || aside > radiusAt(cone, depth)) continue;
    const float cost = depth + axisPreference * aside;
    if (cost < best.cost && (!accepts || accepts(i))) best = {i, cost};
  }
}

} // namespace

PointHierarchy::PointHierarchy(const Eigen::Matrix3Xf& points) {
  if (points.cols() == 0) return;
  points_ = points.cols();
  const auto runs = static_cast<std::uint64_t>((points.cols() + runLength - 1) / runLength);
  leaves_ = static_cast<Eigen::Index>(std::bit_ceil(runs));
  boxes_.resize(static_cast<std::size_t>(2 * leaves_ - 1));
  for (Eigen::Index i = 0; i < points.cols(); ++i)
    boxes_[static_cast<std::size_t>(leaves_ - 1 + i / runLength)].extend(points.col(i));
  for (Eigen::Index box = leaves_ - 2; box >= 0; --box) {
    const auto left = static_cast<std::size_t>(2 * box + 1);
    boxes_[static_cast<std::size_t>(box)] = boxes_[left].merged(boxes_[left + 1]);
  }
}

Eigen::AlignedBox3f PointHierarchy::bounds() const {
  return boxes_.empty() ? Eigen::AlignedBox3f() : boxes_.front();
}

float PointHierarchy::distance(const Eigen::Matrix3Xf& points, const Eigen::Vector3f& place,
                               float beyond) const {
  const float least = beyond < 0 ? -1 : beyond * beyond;
  float best = std::numeric_limits<float>::infinity(); // squared
  std::vector<Eigen::Index> open;
  if (!boxes_.empty()) open.push_back(0);
  const auto to = [&](Eigen::Index box) {
    const Eigen::AlignedBox3f& bounds = boxes_[static_cast<std::size_t>(box)];
    return bounds.isEmpty() ? std::numeric_limits<float>::infinity()
                            : bounds.squaredExteriorDistance(place);
  };
  while (!open.empty()) {
    const Eigen::Index box = open.back();
    open.pop_back();
    if (!(to(box) < best)) continue;
    if (box >= leaves_ - 1) {
      const Eigen::Index begin = (box - (leaves_ - 1)) * runLength;
      for (Eigen::Index i = begin; i < std::min(begin + runLength, points_); ++i) {
        const float squared = (points.col(i) - place).squaredNorm();
        if (squared > least && squared < best) best = squared;
      }
      continue;
    }
    const bool leftFirst = to(2 * box + 1) <= to(2 * box + 2); // the last pushed is looked at first
    open.push_back(leftFirst ? 2 * box + 2 : 2 * box + 1);
    open.push_back(leftFirst ? 2 * box + 1 : 2 * box + 2);
  }
  return std::sqrt(best);
}

std::optional<Eigen::Index>
PointHierarchy::pick(const Eigen::Matrix3Xf& points, const ViewCone& cone,
                     const std::function<bool(Eigen::Index)>& accepts) const {
  Hit best;
  std::vector<Eigen::Index> open;
  if (!boxes_.empty()) open.push_back(0);
  while (!open.empty()) {
    const Eigen::Index box = open.back();
    open.pop_back();
    if (leastCost(boxes_[static_cast<std::size_t>(box)], cone) >= best.cost) continue;
    if (box >= leaves_ - 1) {
      const Eigen::Index begin = (box - (leaves_ - 1)) * runLength;
      pickInRun(points, begin, std::min(begin + runLength, points.cols()), cone, accepts, best);
      continue;
    }
    const Eigen::Index left = 2 * box + 1;
    const float leftCost = leastCost(boxes_[static_cast<std::size_t>(left)], cone);
    const float rightCost = leastCost(boxes_[static_cast<std::size_t>(left + 1)], cone);
    const bool leftFirst = leftCost <= rightCost; // the last pushed is looked at first
    if (std::max(leftCost, rightCost) < best.cost) open.push_back(leftFirst ? left + 1 : left);
    if (std::min(leftCost, rightCost) < best.cost) open.push_back(leftFirst ? left : left + 1);
  }
  if (best.point < 0) return std::nullopt;
  return best.point;
}

} // namespace espalier
