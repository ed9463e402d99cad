#include "core/surface/envelopes/outline.h"

#include "core/base/plane_hull.h"

#include <Eigen/Eigenvalues>

#include <limits>
#include <numbers>

namespace espalier {
namespace {

double crossOf(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

} // namespace

Outline outlineOf(const Crown& crown) {
  Outline outline;
  std::vector<Eigen::Vector2d> seen;
  for (const auto& corner : crown.hull.corners.colwise())
    seen.emplace_back(corner.head<2>());
  outline.corners = planeHull(seen);
  const Eigen::Vector2d about = outline.corners.front();
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  Eigen::Matrix2d squares = Eigen::Matrix2d::Zero(); // of triangles about the first corner
  for (std::size_t i = 1; i + 1 < outline.corners.size(); ++i) {
    const Eigen::Vector2d a = outline.corners[i] - about;
    const Eigen::Vector2d b = outline.corners[i + 1] - about;
    const double part = crossOf(a, b) / 2;
    outline.area += part;
    moment += part / 3 * (a + b);
    squares += part / 12 * (a * a.transpose() + b * b.transpose() + (a + b) * (a + b).transpose());
  }
  const Eigen::Vector2d middle = moment / outline.area;
  outline.middle = about + middle;
  const Eigen::Matrix2d spread = squares / outline.area - middle * middle.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(spread);
  if (solver.eigenvalues()[1] > solver.eigenvalues()[0] * (1 + 1e-6))
    outline.along = solver.eigenvectors().col(1);
  return outline;
}

OutlineBox boxAround(const Outline& outline) {
  OutlineBox best{};
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.corners.size(); ++i) {
    const Eigen::Vector2d along =
        (outline.corners[(i + 1) % outline.corners.size()] - outline.corners[i]).normalized();
    Eigen::Matrix2d axes;
    axes << along.x(), along.y(), -along.y(), along.x();
    Eigen::Vector2d low = axes * outline.corners.front();
    Eigen::Vector2d high = low;
    for (const Eigen::Vector2d& corner : outline.corners) {
      low = low.cwiseMin(axes * corner);
      high = high.cwiseMax(axes * corner);
    }
    const Eigen::Vector2d sides = high - low;
    if (sides.prod() >= least) continue;
    least = sides.prod();
    best = {.along = along, .middle = axes.transpose() * (low + high) / 2, .sides = sides};
    if (sides.y() > sides.x())
      best = {.along = axes.row(1).transpose(), .middle = best.middle, .sides = sides.reverse()};
  }
  return best;
}

OutlineReach::OutlineReach(const Outline& outline, const Eigen::Vector2d& from) {
  for (const Eigen::Vector2d& corner : outline.corners) {
    const Eigen::Vector2d at = corner - from;
    corners_.emplace_back(std::atan2(at.y(), at.x()), at);
  }
  std::ranges::sort(corners_, {}, &std::pair<double, Eigen::Vector2d>::first);
}

double OutlineReach::at(double azimuth) const {
  const double angle = std::remainder(azimuth, 2 * std::numbers::pi);
  auto next =
      std::ranges::upper_bound(corners_, angle, {}, &std::pair<double, Eigen::Vector2d>::first);
  const Eigen::Vector2d& a = (next == corners_.begin() ? corners_.end() : next)[-1].second;
  const Eigen::Vector2d& b = (next == corners_.end() ? corners_.begin() : next)->second;
  const Eigen::Vector2d along(std::cos(angle), std::sin(angle));
  const double turn = crossOf(along, b - a);
  return turn <= 0 ? std::max(a.norm(), b.norm()) : crossOf(a, b) / turn;
}

std::vector<double> OutlineReach::cornerAzimuths() const {
  std::vector<double> azimuths;
  for (const auto& [azimuth, corner] : corners_)
    azimuths.push_back(azimuth);
  return azimuths;
}

} // namespace espalier
