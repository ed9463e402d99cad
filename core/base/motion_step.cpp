#include "core/base/motion_step.h"

#include <Eigen/Cholesky>

#include <utility>

namespace espalier {

MotionStep::MotionStep(Eigen::Vector3d center, double size)
    : center_(std::move(center)), size_(size) {}

void MotionStep::add(const Eigen::Vector3d& place, const Eigen::Vector3d& target,
                     const Eigen::Matrix3d& weight) {
  // Turns in units of the shifts.
  const Eigen::Vector3d arm = (place - center_) / size_;
  Eigen::Matrix<double, 3, 6> jacobian;
  jacobian << Eigen::Matrix3d::Identity(),
      (Eigen::Matrix3d() << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0)
          .finished();
  normal_ += jacobian.transpose() * weight * jacobian;
  right_ += jacobian.transpose() * (weight * (target - place));
}

Eigen::Isometry3d MotionStep::motion(bool turns) const {
  Eigen::Matrix<double, 6, 1> step = Eigen::Matrix<double, 6, 1>::Zero();
  if (turns) {
    Eigen::Matrix<double, 6, 6> normal = normal_;
    normal.diagonal().array() += 1e-9 * normal.trace();
    step = normal.ldlt().solve(right_);
  } else {
    step.head<3>() = normal_.topLeftCorner<3, 3>().ldlt().solve(right_.head<3>());
  }
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  const double angle = step.tail<3>().norm() / size_;
  if (angle > 0) motion.rotate(Eigen::AngleAxisd(angle, step.tail<3>().normalized()));
  motion.translation() = center_ + step.head<3>() - motion.linear() * center_;
  return motion;
}

double MotionStep::lengthOf(const Eigen::Isometry3d& motion) const {
  return (motion * center_ - center_).norm() +
         (motion.linear() - Eigen::Matrix3d::Identity()).norm() * size_;
}

} // namespace espalier
