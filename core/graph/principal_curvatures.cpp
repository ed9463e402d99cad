#include "core/graph/principal_curvatures.h"

#include "core/base/parallel.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

/// z = c0 + c1 x + c2 y + c3 x^2 + c4 x y + c5 y^2 over the tangent plane.
using Quadric = Eigen::Matrix<double, 6, 1>;

/// The curvatures at the origin of the surface whose height over right x up is the quadric.
PrincipalCurvatures curvaturesOf(const Quadric& c, const Eigen::Vector3d& right,
                                 const Eigen::Vector3d& up, const Eigen::Vector3d& normal) {
  const double stretch = std::sqrt(1 + c[1] * c[1] + c[2] * c[2]);
  Eigen::Matrix2d first;
  first << 1 + c[1] * c[1], c[1] * c[2], c[1] * c[2], 1 + c[2] * c[2];
  Eigen::Matrix2d second;
  second << 2 * c[3], c[4], c[4], 2 * c[5];
  second /= -stretch; // bending away from the normal is positive
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d> solver(second, first);
  const auto inSpace = [&](const Eigen::Vector2d& d) {
    const double rise = c[1] * d.x() + c[2] * d.y();
    return Eigen::Vector3f((d.x() * right + d.y() * up + rise * normal).normalized().cast<float>());
  };
  return {.greatest = solver.eigenvalues()[1],
          .least = solver.eigenvalues()[0],
          .greatestDirection = inSpace(solver.eigenvectors().col(1)),
          .leastDirection = inSpace(solver.eigenvectors().col(0))};
}

} // namespace

std::vector<PrincipalCurvatures> principalCurvatures(const Eigen::Matrix3Xf& points,
                                                     const Eigen::Matrix3Xf& normals,
                                                     const Neighborhoods& neighborhoods,
                                                     const Progress& progress) {
  std::vector<PrincipalCurvatures> result(static_cast<std::size_t>(points.cols()));
  const auto fit = [&](Eigen::Index i) {
    const auto neighbors = neighborhoods.of(i);
    if (neighbors.size() < 6) return;
    const Eigen::Vector3d normal = normals.col(i).cast<double>().normalized();
    const Eigen::Vector3d right = normal.unitOrthogonal();
    const Eigen::Vector3d up = normal.cross(right);
    double size = 0; // of the neighborhood, so that the equations know no unit
    for (const std::uint32_t other : neighbors)
      size = std::max(size, (points.col(other) - points.col(i)).cast<double>().norm());
    if (size == 0) return;
    Eigen::Matrix<double, 6, 6> sums = Eigen::Matrix<double, 6, 6>::Zero();
    Quadric heights = Quadric::Zero();
    const auto add = [&](const Eigen::Vector3d& d) {
      const double x = d.dot(right);
      const double y = d.dot(up);
      const Quadric row = (Quadric() << 1, x, y, x * x, x * y, y * y).finished();
      sums.noalias() += row * row.transpose();
      heights += d.dot(normal) * row;
    };
    add(Eigen::Vector3d::Zero());
    for (const std::uint32_t other : neighbors)
      add((points.col(other) - points.col(i)).cast<double>() / size);
    const Eigen::FullPivLU<Eigen::Matrix<double, 6, 6>> solver(
        Eigen::FullPivLU<Eigen::Matrix<double, 6, 6>>(sums).setThreshold(1e-8));
    if (!solver.isInvertible()) return;
    auto& found = result[static_cast<std::size_t>(i)];
    found = curvaturesOf(solver.solve(heights), right, up, normal);
    found.greatest /= size;
    found.least /= size;
  };
  parallelFor(points.cols(), fit, progress);
  return result;
}

} // namespace espalier
