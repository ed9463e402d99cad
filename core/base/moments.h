#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <utility>

namespace espalier {

/// Count, mean and spread of points, collected one by one about a place near them.
class Moments {
public:
  explicit Moments(Eigen::Vector3d about = Eigen::Vector3d::Zero()) : about_(std::move(about)) {}

  void add(const Eigen::Vector3d& point) {
    const Eigen::Vector3d d = point - about_;
    ++count_;
    sum_ += d;
    squares_.noalias() += d * d.transpose();
  }
  void add(const Eigen::Vector3f& point) { add(Eigen::Vector3d(point.cast<double>())); }

  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] Eigen::Vector3d mean() const { return about_ + sum_ / count_; } // pre: count() > 0

  /// Variances and directions of the principal components, the least first. pre: count() > 0
  [[nodiscard]] Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> components() const {
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
    const Eigen::Vector3d shift = sum_ / count_;
    const Eigen::Matrix3d covariance = squares_ / count_ - shift * shift.transpose();
    solver.computeDirect(covariance); // closed form: four times as fast as by iteration
    return solver;
  }

private:
  Eigen::Vector3d about_;
  int count_ = 0;
  Eigen::Vector3d sum_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares_ = Eigen::Matrix3d::Zero();
};

} // namespace espalier
