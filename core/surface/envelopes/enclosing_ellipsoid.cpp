#include "core/surface/envelopes/enclosing_ellipsoid.h"

#include "core/base/shown.h"
#include "core/surface/envelopes/rings.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <numbers>

namespace espalier {
namespace {

/// (x - center)^T shape^-1 (x - center) <= 1.
struct EllipsoidShape {
  Eigen::Vector3d center;
  Eigen::Matrix3d shape;
};

/// Weights of points, of which the ellipsoid is made: moved to that which is farthest out, or away
/// from that which is farthest in.
EllipsoidShape leastAbout(const Eigen::Matrix3Xd& points, const Progress& progress) {
  const Eigen::Index count = points.cols();
  Eigen::Matrix4Xd lifted(4, count);
  lifted << points, Eigen::RowVectorXd::Ones(count);
  Eigen::VectorXd weights = Eigen::VectorXd::Constant(count, 1.0 / static_cast<double>(count));
  for (int step = 0; step < 20'000; ++step) {
    if (step % 16 == 0) progress.check();
    const Eigen::Matrix4d moments = lifted * weights.asDiagonal() * lifted.transpose();
    const Eigen::VectorXd far =
        lifted.cwiseProduct(moments.inverse() * lifted).colwise().sum().transpose();
    Eigen::Index outer = 0;
    const double most = far.maxCoeff(&outer);
    Eigen::Index inner = 0;
    const double least = (weights.array() > 0).select(far.array(), most).minCoeff(&inner);
    if (most / 4 - 1 < 1e-4 && 1 - least / 4 < 1e-4) break;
    const bool isOut = most / 4 - 1 >= 1 - least / 4;
    const double at = isOut ? most : least;
    double share = (at - 4) / (4 * (at - 1));
    if (!isOut) share = std::max(share, -weights[inner] / (1 - weights[inner]));
    if (!isOut && at <= 1) share = -weights[inner] / (1 - weights[inner]);
    weights *= 1 - share;
    const Eigen::Index moved = isOut ? outer : inner;
    weights[moved] = std::max(0.0, weights[moved] + share);
  }
  const Eigen::Vector3d center = points * weights;
  const Eigen::Matrix3Xd from = points.colwise() - center;
  const Eigen::Matrix3d shape = 3 * from * weights.asDiagonal() * from.transpose();
  const double most =
      from.cwiseProduct(shape.inverse() * from).colwise().sum().maxCoeff(); // all are inside
  return {.center = center, .shape = shape * std::max(most, 1.0)};
}

} // namespace

Envelope ellipsoidOf(const Eigen::Vector3d& center, const Eigen::Vector3d& semiAxes,
                     const Eigen::Matrix3d& directions) {
  Eigen::Matrix3d turn = directions.rowwise().reverse(); // the poles are on the first
  if (turn.determinant() < 0) turn.col(0) = -turn.col(0);
  const Eigen::Vector3d axes = semiAxes.reverse();
  std::vector<Ring> rings;
  const auto place = [&](double level, double around) -> Eigen::Vector3d {
    const Eigen::Vector3d on(std::sin(level) * std::cos(around), std::sin(level) * std::sin(around),
                             -std::cos(level));
    return center + turn * axes.cwiseProduct(on);
  };
  for (int level = 1; level < ringLevels; ++level) {
    Ring& ring = rings.emplace_back();
    for (int i = 0; i < ringCorners; ++i)
      ring.push_back(
          place(std::numbers::pi * level / ringLevels, 2 * std::numbers::pi * i / ringCorners));
  }
  Envelope envelope = envelopeOf(meshOfRings(place(0, 0), rings, place(std::numbers::pi, 0)));
  envelope.parameters.push_back(
      {.name = "semi_axis_a", .label = Shown::tr("semi-axis a"), .value = semiAxes[0]});
  envelope.parameters.push_back(
      {.name = "semi_axis_b", .label = Shown::tr("semi-axis b"), .value = semiAxes[1]});
  envelope.parameters.push_back(
      {.name = "semi_axis_c", .label = Shown::tr("semi-axis c"), .value = semiAxes[2]});
  addPlace(envelope.parameters, "center", Shown::tr("center"), center);
  envelope.parameters.push_back(
      {.name = "lean",
       .label = Shown::tr("lean"),
       .kind = EnvelopeParameter::Kind::angle,
       .value = std::acos(std::min(1.0, turn.row(2).cwiseAbs().maxCoeff()))});
  envelope.volume = 4 * std::numbers::pi / 3 * semiAxes.prod();
  envelope.height = 2 * semiAxes.cwiseProduct(directions.row(2).transpose()).norm();
  envelope.directions = directions;
  return envelope;
}

Envelope ellipsoidEnvelope(const Crown& crown, const Progress& progress) {
  const auto [center, shape] = leastAbout(crown.hull.corners, progress);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(shape); // shortest first
  return ellipsoidOf(center, solver.eigenvalues().cwiseSqrt().reverse(),
                     solver.eigenvectors().rowwise().reverse());
}

} // namespace espalier
