#include "core/contract/least_squares_surface.h"

#include "core/base/parallel.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <vector>

namespace espalier {
namespace {

constexpr int fewestNeighbors = 6;
constexpr double leastFlatness = 0.2; // of variances, through the surface and along it

/// The points about a place, in radii, each with its weight.
struct WeightedBall {
  std::vector<Eigen::Vector3d> points;
  std::vector<double> weights;

  WeightedBall(const Eigen::Matrix3Xf& all, const SpatialIndex& index, const Eigen::Vector3d& place,
               double radius) {
    for (const Neighbor& each : index.within(place.cast<float>(), static_cast<float>(radius))) {
      const Eigen::Vector3d from = (all.col(each.index).cast<double>() - place) / radius;
      const double rest = 1 - from.squaredNorm();
      if (rest <= 0) continue;
      points.push_back(from);
      weights.push_back(rest * rest * rest * rest);
    }
  }
};

/// The plane of the points of a ball.
struct WeightedPlane {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  bool isSurface = false; // the points spread along it

  explicit WeightedPlane(const WeightedBall& ball) {
    if (ball.points.size() < fewestNeighbors) return;
    double sum = 0;
    for (std::size_t i = 0; i < ball.points.size(); ++i) {
      mean += ball.weights[i] * ball.points[i];
      sum += ball.weights[i];
    }
    mean /= sum;
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (std::size_t i = 0; i < ball.points.size(); ++i) {
      const Eigen::Vector3d from = ball.points[i] - mean;
      spread.noalias() += ball.weights[i] * from * from.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> parts(spread / sum);
    normal = parts.eigenvectors().col(0);
    constexpr double coincident = 1e-12; // variance, in squared radii
    isSurface = parts.eigenvalues()[1] > coincident &&
                parts.eigenvalues()[0] < leastFlatness * parts.eigenvalues()[1];
  }

  [[nodiscard]] Eigen::Vector3d foot(const Eigen::Vector3d& place) const {
    return place - (place - mean).dot(normal) * normal;
  }
};

/// u0 + u . x + q |x|^2 = 0: a sphere, or a plane where q is 0.
struct AlgebraicSphere {
  double constant = 0;
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();
  double square = 0;

  /// The least sum of weighted squares where |u|^2 - 4 u0 q = 1: the value then is the distance, to
  /// first order, whatever the bend.
  explicit AlgebraicSphere(const WeightedBall& ball) {
    using Vector5 = Eigen::Matrix<double, 5, 1>;
    using Matrix5 = Eigen::Matrix<double, 5, 5>;
    Matrix5 squares = Matrix5::Zero();
    double sum = 0;
    for (std::size_t i = 0; i < ball.points.size(); ++i) {
      Vector5 row;
      row << 1, ball.points[i], ball.points[i].squaredNorm();
      squares.noalias() += ball.weights[i] * row * row.transpose();
      sum += ball.weights[i];
    }
    constexpr double rounding = 1e-12; // points exactly on a sphere leave no squares
    squares = squares / sum + rounding * Matrix5::Identity();
    Matrix5 norm = Matrix5::Zero();
    norm(0, 4) = norm(4, 0) = -2;
    norm(1, 1) = norm(2, 2) = norm(3, 3) = 1;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix5> solver(norm, squares);
    const Vector5 best = solver.eigenvectors().col(4); // the greatest norm for its squares
    constant = best[0];
    linear = best.segment<3>(1);
    square = best[4];
  }

  /// The point of it that is nearest to a place; none where that is not known, as at its center.
  [[nodiscard]] std::optional<Eigen::Vector3d> foot(const Eigen::Vector3d& place) const {
    const double value = constant + linear.dot(place) + square * place.squaredNorm();
    const Eigen::Vector3d slope = linear + 2 * square * place;
    const double steep = slope.squaredNorm();
    const double inside = steep - 4 * square * value; // |u|^2 - 4 u0 q: of the same sign everywhere
    if (!(steep > 0) || !(inside > 0)) return std::nullopt;
    // The root of value + steep t + q steep t^2 that is near 0, without a difference of likes.
    const double step = -2 * value / (steep + std::sqrt(steep * inside));
    return place + step * slope;
  }
};

} // namespace

std::optional<Eigen::Vector3d> LeastSquaresSurface::nearest(const Eigen::Vector3d& place,
                                                            double radius) const {
  constexpr int most = 8;          // fits; two or three do where points are even
  constexpr double settled = 1e-3; // in radii
  Eigen::Vector3d about = place;   // where the points are weighted from
  for (int i = 0; i < most; ++i) {
    const WeightedBall ball(points_, index_, about, radius);
    const WeightedPlane plane(ball);
    if (!plane.isSurface) return std::nullopt;
    const Eigen::Vector3d from = (place - about) / radius;
    const std::optional<Eigen::Vector3d> foot =
        shape_ == LocalShape::plane ? plane.foot(from) : AlgebraicSphere(ball).foot(from);
    if (!foot || !foot->allFinite() || (*foot - from).norm() > 1) return std::nullopt;
    about += radius * *foot;
    if (foot->norm() < settled) break;
  }
  return about;
}

Eigen::Matrix3Xf smoothedPoints(const Eigen::Matrix3Xf& points, LocalShape shape,
                                const LeastSquaresOptions& options, const Progress& progress) {
  Eigen::Matrix3Xf now = points;
  for (int i = 0; i < options.iterations; ++i) {
    const Progress part = progress.part(static_cast<double>(i) / options.iterations,
                                        static_cast<double>(i + 1) / options.iterations);
    const SpatialIndex index(now, part);
    const LeastSquaresSurface surface(now, index, shape);
    Eigen::Matrix3Xf next = now;
    parallelFor(
        now.cols(),
        [&](Eigen::Index point) {
          const auto place = surface.nearest(now.col(point).cast<double>(), options.radius);
          if (place) next.col(point) = place->cast<float>();
        },
        part, 64);
    now = std::move(next);
  }
  return now;
}

} // namespace espalier
