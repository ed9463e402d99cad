#include "core/radius/cylinder_fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace espalier {
namespace {

using Points = std::vector<Eigen::Vector3d>;

/// A point as seen along the axis of a cylinder.
struct Sight {
  Eigen::Vector2d across; // from the axis [L]
  double along = 0;       // from the point of the axis [L]
  double off = 0;         // from the surface, < 0 inside [L]
};

struct Frame {
  Eigen::Vector3d right;
  Eigen::Vector3d up;
};

Frame frameOf(const FittedCylinder& cylinder) {
  const Eigen::Vector3d right = cylinder.direction.unitOrthogonal();
  return {right, cylinder.direction.cross(right)};
}

std::vector<Sight> look(const Points& points, const FittedCylinder& cylinder, const Frame& frame) {
  std::vector<Sight> sights;
  sights.reserve(points.size());
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d d = point - cylinder.point;
    const Eigen::Vector2d across(d.dot(frame.right), d.dot(frame.up));
    sights.push_back({.across = across,
                      .along = d.dot(cylinder.direction),
                      .off = across.norm() - cylinder.radius});
  }
  return sights;
}

/// The distance from which on points do not count [L]: of noise, but no less than the wood is
/// rough.
double limitOf(const std::vector<Sight>& sights, double radius) {
  std::vector<double> distances;
  distances.reserve(sights.size());
  for (const Sight& sight : sights)
    distances.push_back(std::abs(sight.off));
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  constexpr double deviation = 1.4826; // per median distance, of normal noise
  constexpr double farthest = 4.685;   // standard deviations: Tukey's, 95 % efficient
  constexpr double roughness = 0.02;   // of the radius
  return std::max(farthest * deviation * *middle, roughness * radius);
}

double weightOf(double off, double limit) {
  const double share = off / limit;
  return std::abs(share) >= 1 ? 0 : std::pow(1 - share * share, 2);
}

/// The step to the least squares of the distances, linear about the cylinder: of its point across
/// the axis, of its direction, and of its radius.
Eigen::Matrix<double, 5, 1> stepFrom(const std::vector<Sight>& sights, double limit) {
  Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
  Eigen::Matrix<double, 5, 1> right = Eigen::Matrix<double, 5, 1>::Zero();
  for (const Sight& sight : sights) {
    const double weight = weightOf(sight.off, limit);
    const double distance = sight.across.norm();
    if (weight == 0 || distance == 0) continue;
    const Eigen::Vector2d out = sight.across / distance;
    Eigen::Matrix<double, 5, 1> slope;
    slope << -out, -sight.along * out, -1;
    normal.noalias() += weight * slope * slope.transpose();
    right.noalias() -= weight * sight.off * slope;
  }
  constexpr double damping = 1e-6; // holds what the points do not fix, as on a short arc
  normal.diagonal() *= 1 + damping;
  return normal.ldlt().solve(right);
}

/// Fills in what the points say of a cylinder.
void judge(FittedCylinder& cylinder, const std::vector<Sight>& sights, double limit) {
  constexpr int sectors = 16;
  std::array<bool, sectors> isHit{};
  double squares = 0;
  double count = 0;
  for (const Sight& sight : sights) {
    if (std::abs(sight.off) >= limit) continue;
    squares += sight.off * sight.off;
    count += 1;
    const double turn =
        std::atan2(sight.across.y(), sight.across.x()) / (2 * std::numbers::pi) + 0.5;
    isHit[static_cast<std::size_t>(std::min(sectors - 1, static_cast<int>(turn * sectors)))] = true;
  }
  cylinder.error = count > 0 ? std::sqrt(squares / count) : 0;
  cylinder.points = static_cast<double>(sights.size());
  cylinder.kept = count / static_cast<double>(sights.size());
  cylinder.coverage = static_cast<double>(std::ranges::count(isHit, true)) / sectors;
}

} // namespace

std::optional<FittedCylinder> fitCylinder(const Points& points, const FittedCylinder& start) {
  constexpr std::size_t fewest = 8;
  if (points.size() < fewest) return std::nullopt;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points)
    middle += point / static_cast<double>(points.size());
  double farthest = 0;
  for (const Eigen::Vector3d& point : points)
    farthest = std::max(farthest, (point - middle).norm());

  FittedCylinder cylinder = start;
  constexpr int mostSteps = 30;
  for (int i = 0; i < mostSteps; ++i) {
    cylinder.point += (middle - cylinder.point).dot(cylinder.direction) * cylinder.direction;
    const Frame frame = frameOf(cylinder);
    const std::vector<Sight> sights = look(points, cylinder, frame);
    const double limit = limitOf(sights, cylinder.radius);
    Eigen::Matrix<double, 5, 1> step = stepFrom(sights, limit);
    if (!step.allFinite()) return std::nullopt;
    const double length = std::max(step.head<2>().norm(), std::abs(step[4]));
    if (length > cylinder.radius / 2) step *= cylinder.radius / 2 / length; // linear no farther
    cylinder.point += step[0] * frame.right + step[1] * frame.up;
    cylinder.direction =
        (cylinder.direction + step[2] * frame.right + step[3] * frame.up).normalized();
    cylinder.radius += step[4];
    if (!cylinder.direction.allFinite() || !(cylinder.radius > 0) ||
        cylinder.radius > 10 * farthest || (cylinder.point - middle).norm() > 10 * farthest)
      return std::nullopt;
    if (length < 1e-7 * cylinder.radius) break;
  }
  const std::vector<Sight> sights = look(points, cylinder, frameOf(cylinder));
  judge(cylinder, sights, limitOf(sights, cylinder.radius));
  return cylinder;
}

} // namespace espalier
