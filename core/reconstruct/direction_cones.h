#pragma once

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// A unit direction, and one across it that turns with it as little as it can.
struct Heading {
  Eigen::Vector3d along = Eigen::Vector3d::UnitZ();
  Eigen::Vector3d side = Eigen::Vector3d::UnitX(); // unit, orthogonal to along

  /// The heading of a child that goes on in `direction`, unit.
  [[nodiscard]] Heading turnedTo(const Eigen::Vector3d& direction) const;
};

/// A node looks for its children through cones: one ahead, and rings of them around it.
class DirectionCones {
public:
  /// @param angle full opening of each cone, and the polar angle from ring to ring [rad], in
  ///              (0, pi / 2); rings stand at less than a right angle to the heading
  explicit DirectionCones(double angle);

  /// Their axes as they stand to a heading, unit; the one ahead first.
  [[nodiscard]] std::vector<Eigen::Vector3d> axes(const Heading& heading) const;

  /// Groups directions by the cone they are in, or by that whose axis is nearest if they are in
  /// several; those that are in none are left out.
  ///
  /// @param directions unit vectors, or zero, which is in none
  /// @return groups of places in `directions`, none of them empty; in order of the cones, the one
  ///         ahead first
  [[nodiscard]] std::vector<std::vector<std::size_t>>
  groups(const Heading& heading, const std::vector<Eigen::Vector3d>& directions) const;

private:
  std::vector<Eigen::Vector3d> axes_; // along x: the side; along z: the heading
  double leastCosine_ = 1;
};

} // namespace espalier
