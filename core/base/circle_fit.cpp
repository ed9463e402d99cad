#include "core/base/circle_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace espalier {
namespace {

double coverageAround(const Eigen::Vector2d& center, const std::vector<Eigen::Vector2d>& points) {
  constexpr int sectors = 16;
  std::array<bool, sectors> isHit{};
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d d = point - center;
    const double turn = std::atan2(d.y(), d.x()) / (2 * std::numbers::pi) + 0.5; // [0, 1]
    isHit[static_cast<std::size_t>(std::min(sectors - 1, static_cast<int>(turn * sectors)))] = true;
  }
  return static_cast<double>(std::count(isHit.begin(), isHit.end(), true)) / sectors;
}

} // namespace

std::optional<FittedCircle> fitCircle(const std::vector<Eigen::Vector2d>& points) {
  if (points.size() < 3) return std::nullopt;
  const auto n = static_cast<double>(points.size());
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& point : points)
    mean += point / n;
  double xx = 0;
  double yy = 0;
  double xy = 0;
  double xz = 0;
  double yz = 0;
  double zz = 0;
  for (const Eigen::Vector2d& point : points) {
    const Eigen::Vector2d d = point - mean;
    const double z = d.squaredNorm();
    xx += d.x() * d.x() / n;
    yy += d.y() * d.y() / n;
    xy += d.x() * d.y() / n;
    xz += d.x() * z / n;
    yz += d.y() * z / n;
    zz += z * z / n;
  }
  // Characteristic polynomial of the constrained least-squares problem; its smallest root is
  // wanted.
  const double size = xx + yy;
  const double area = xx * yy - xy * xy;
  if (!(area > 1e-12 * size * size)) return std::nullopt;
  const double variance = zz - size * size;
  const double a3 = 4 * size;
  const double a2 = -3 * size * size - zz;
  const double a1 = variance * size + 4 * area * size - xz * xz - yz * yz;
  const double a0 = xz * (xz * yy - yz * xy) + yz * (yz * xx - xz * xy) - variance * area;
  double root = 0;
  double value = a0;
  for (int i = 0; i < 50; ++i) {
    const double next = root - value / (a1 + root * (2 * a2 + 3 * a3 * root));
    if (!std::isfinite(next) || next == root) break;
    const double nextValue = a0 + next * (a1 + next * (a2 + next * a3));
    if (std::abs(nextValue) >= std::abs(value)) break;
    root = next;
    value = nextValue;
  }
  const double determinant = root * root - root * size + area;
  if (determinant == 0) return std::nullopt;
  const Eigen::Vector2d offset =
      Eigen::Vector2d(xz * (yy - root) - yz * xy, yz * (xx - root) - xz * xy) / (2 * determinant);
  const Eigen::Vector2d center = mean + offset;
  const double radius = std::sqrt(offset.squaredNorm() + size);
  if (!center.allFinite() || !std::isfinite(radius)) return std::nullopt;
  return judgedCircle(center, radius, points);
}

FittedCircle judgedCircle(const Eigen::Vector2d& center, double radius,
                          const std::vector<Eigen::Vector2d>& points) {
  const auto n = static_cast<double>(points.size());
  double squares = 0;
  for (const Eigen::Vector2d& point : points)
    squares += std::pow((point - center).norm() - radius, 2) / n;
  return {.center = center,
          .radius = radius,
          .error = std::sqrt(squares),
          .coverage = coverageAround(center, points)};
}

} // namespace espalier
