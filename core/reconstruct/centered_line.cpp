#include "core/reconstruct/centered_line.h"

#include "core/base/circle_fit.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace espalier {
namespace {

using Eigen::Vector3d;
using Line = std::vector<Vector3d>;

double distanceToPiece(const Vector3d& place, const Vector3d& from, const Vector3d& to) {
  const Vector3d along = to - from;
  const double squared = along.squaredNorm();
  const double share =
      squared > 0 ? std::clamp((place - from).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (place - from - share * along).norm();
}

constexpr std::size_t fewest = 8; // points for a circle to mean something

std::vector<Eigen::Vector2d> acrossAxis(const Vector3d& place, const Vector3d& right,
                                        const Vector3d& up, const std::vector<Vector3d>& points) {
  std::vector<Eigen::Vector2d> section;
  section.reserve(points.size());
  for (const Vector3d& point : points)
    section.emplace_back((point - place).dot(right), (point - place).dot(up));
  return section;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

/// Leaves out what is far from the middle of most: a circle fitted to all would reach out for it.
void dropFarOff(std::vector<Eigen::Vector2d>& section) {
  constexpr double farthest = 1.6; // in median distances
  if (section.empty()) return;
  std::vector<double> across;
  std::vector<double> along;
  for (const Eigen::Vector2d& point : section) {
    across.push_back(point.x());
    along.push_back(point.y());
  }
  const Eigen::Vector2d center(median(across), median(along));
  std::vector<double> distances;
  distances.reserve(section.size());
  for (const Eigen::Vector2d& point : section)
    distances.push_back((point - center).norm());
  const double limit = farthest * median(distances);
  std::erase_if(section,
                [&](const Eigen::Vector2d& point) { return (point - center).norm() > limit; });
}

} // namespace

double lengthOfLine(const Line& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i)
    length += (line[i] - line[i - 1]).norm();
  return length;
}

double distanceToLine(const Vector3d& place, const Line& line) {
  assert(!line.empty());
  double least = (place - line.front()).norm();
  for (std::size_t i = 1; i < line.size(); ++i)
    least = std::min(least, distanceToPiece(place, line[i - 1], line[i]));
  return least;
}

Line spacedEvenly(const Line& line, double step) {
  assert(line.size() > 1 && step > 0);
  const double length = lengthOfLine(line);
  const auto count = static_cast<std::size_t>(std::max(1.0, std::round(length / step)));
  Line result = {line.front()};
  double passed = 0; // up to line[at]
  std::size_t at = 0;
  for (std::size_t i = 1; i < count; ++i) {
    const double wanted = length * static_cast<double>(i) / static_cast<double>(count);
    double piece = (line[at + 1] - line[at]).norm();
    while (passed + piece < wanted && at + 2 < line.size()) {
      passed += piece;
      ++at;
      piece = (line[at + 1] - line[at]).norm();
    }
    const double share = piece > 0 ? std::min((wanted - passed) / piece, 1.0) : 0;
    result.push_back(line[at] + share * (line[at + 1] - line[at]));
  }
  result.push_back(line.back());
  return result;
}

Line smoothedLine(const Line& line, double share, int rounds) {
  Line result = line;
  for (int round = 0; round < rounds; ++round) {
    const Line before = result;
    for (std::size_t i = 1; i + 1 < before.size(); ++i)
      result[i] = (1 - share) * before[i] + share * (before[i - 1] + before[i + 1]) / 2;
  }
  return result;
}

std::optional<Vector3d> directionAt(const Line& line, std::size_t at) {
  assert(at < line.size());
  const Vector3d along = line[std::min(at + 1, line.size() - 1)] - line[at > 0 ? at - 1 : 0];
  const double length = along.norm();
  if (length == 0) return std::nullopt;
  return along / length;
}

std::optional<WoodSection> sectionAt(const Vector3d& place, const Vector3d& axis,
                                     const std::vector<Vector3d>& points) {
  constexpr double leastCoverage = 0.6; // as core/skeleton/recenter.h
  constexpr double mostError = 0.2;     // in radii: more of it is no circle
  constexpr double farthest = 0.25;     // in radii, off the circle: no bark of it
  constexpr int rounds = 6;
  const Vector3d right = axis.unitOrthogonal();
  const Vector3d up = axis.cross(right);
  std::vector<Eigen::Vector2d> section = acrossAxis(place, right, up, points);
  dropFarOff(section);
  std::optional<FittedCircle> circle;
  for (int round = 0; round < rounds; ++round) {
    if (section.size() < fewest) return std::nullopt;
    circle = fitCircle(section);
    if (!circle) return std::nullopt;
    std::erase_if(section, [&](const Eigen::Vector2d& point) {
      return std::abs((point - circle->center).norm() - circle->radius) > farthest * circle->radius;
    });
  }
  const bool isTrusted =
      circle->coverage >= leastCoverage && circle->error <= mostError * circle->radius;
  // The place is in this wood: a circle that does not hold it is that of a neighbor.
  if (!isTrusted || circle->center.norm() > 1.2 * circle->radius) return std::nullopt;
  return WoodSection{place + circle->center.x() * right + circle->center.y() * up, circle->radius};
}

} // namespace espalier
