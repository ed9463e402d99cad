#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace espalier {

/// The small rigid motion that brings places to their targets: one Gauss-Newton step.
///
/// Places may be added in any order; sums are double. Time O(1) per place.
class MotionStep {
public:
  /// @param center that it turns about [L], amid the places
  /// @param size   of what is moved [L], > 0: turns count in shifts at this distance
  MotionStep(Eigen::Vector3d center, double size);

  /// A place that shall come to its target.
  /// @param weight  3 x 3, symmetric: how much a distance pulls, by its direction
  void add(const Eigen::Vector3d& place, const Eigen::Vector3d& target,
           const Eigen::Matrix3d& weight);

  /// The motion; what the places leave open stays as it is. pre: places were added
  /// @param turns  false: a shift only
  [[nodiscard]] Eigen::Isometry3d motion(bool turns) const;

  /// How far a motion takes what is moved [L].
  [[nodiscard]] double lengthOf(const Eigen::Isometry3d& motion) const;

private:
  Eigen::Vector3d center_;
  double size_;
  Eigen::Matrix<double, 6, 6> normal_ = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> right_ = Eigen::Matrix<double, 6, 1>::Zero();
};

} // namespace espalier
