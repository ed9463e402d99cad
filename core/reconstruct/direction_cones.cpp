#include "core/reconstruct/direction_cones.h"

#include <Eigen/Geometry>

#include <cassert>
#include <cmath>
#include <numbers>

namespace espalier {

Heading Heading::turnedTo(const Eigen::Vector3d& direction) const {
  const Eigen::Vector3d turned =
      Eigen::Quaterniond::FromTwoVectors(along, direction).toRotationMatrix() * side;
  const Eigen::Vector3d across = turned - turned.dot(direction) * direction; // against rounding
  return {direction, across.normalized()};
}

DirectionCones::DirectionCones(double angle)
    : axes_{Eigen::Vector3d::UnitZ()}, leastCosine_(std::cos(angle / 2) - 1e-12) {
  assert(angle > 0 && angle < std::numbers::pi / 2);
  const auto around = static_cast<int>(std::lround(2 * std::numbers::pi / angle));
  for (double polar = angle; polar < std::numbers::pi / 2 - 1e-9; polar += angle)
    for (int i = 0; i < around; ++i) {
      const double azimuth = 2 * std::numbers::pi * i / around;
      axes_.emplace_back(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth),
                         std::cos(polar));
    }
}

std::vector<Eigen::Vector3d> DirectionCones::axes(const Heading& heading) const {
  const Eigen::Vector3d third = heading.along.cross(heading.side);
  std::vector<Eigen::Vector3d> result;
  result.reserve(axes_.size());
  for (const Eigen::Vector3d& axis : axes_)
    result.emplace_back(axis.x() * heading.side + axis.y() * third + axis.z() * heading.along);
  return result;
}

std::vector<std::vector<std::size_t>>
DirectionCones::groups(const Heading& heading,
                       const std::vector<Eigen::Vector3d>& directions) const {
  std::vector<std::vector<std::size_t>> byCone(axes_.size());
  const Eigen::Vector3d third = heading.along.cross(heading.side);
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const Eigen::Vector3d local(directions[i].dot(heading.side), directions[i].dot(third),
                                directions[i].dot(heading.along));
    // Of points at one distance, the least angle is the least distance from the axis.
    std::size_t best = axes_.size();
    double greatest = leastCosine_;
    for (std::size_t cone = 0; cone < axes_.size(); ++cone)
      if (const double cosine = local.dot(axes_[cone]); cosine > greatest) {
        greatest = cosine;
        best = cone;
      }
    if (best < axes_.size()) byCone[best].push_back(i);
  }
  std::erase_if(byCone, [](const std::vector<std::size_t>& group) { return group.empty(); });
  return byCone;
}

} // namespace espalier
