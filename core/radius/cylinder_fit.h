#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace espalier {

/// An endless cylinder, and how well points lie on it.
struct FittedCylinder {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();      // [L], on the axis, amid the points
  Eigen::Vector3d direction = Eigen::Vector3d::UnitZ(); // unit
  double radius = 0;                                    // [L]
  double error = 0;    // root mean square distance of the points that count to it [L]
  double coverage = 0; // share of 16 sectors about the axis that hold points that count, [0, 1]
  double kept = 1;     // share of the points that count, [0, 1]
  double points = 0;   // all that were given
};

/// The cylinder with the least sum of squared distances to points, of which stray ones do not
/// count.
///
/// Gauss-Newton over axis and radius from `start`, whose point, direction and radius are used.
/// After each step points are weighted by Tukey's function of their distance; those farther off
/// than 4.7 standard deviations, which follow from the median distance, do not count.
///
/// @param start  the radius > 0, the direction within about 30 degrees of that of the wood
/// @return none for under 8 points, or if the steps lead away from the points or to no radius
/// Deterministic. Time O(n) for n points, with up to 30 steps.
/// Source: G. Lukacs, R. Martin, D. Marshall, "Faithful least-squares fitting of spheres,
/// cylinders, cones and tori", ECCV 1998; weights: A. E. Beaton, J. W. Tukey, Technometrics 16,
/// 1974.
[[nodiscard]] std::optional<FittedCylinder> fitCylinder(const std::vector<Eigen::Vector3d>& points,
                                                        const FittedCylinder& start);

} // namespace espalier
