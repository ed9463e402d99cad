#include "core/radius/section_circle.h"

#include "core/base/parallel.h"
#include "core/base/plane_hull.h"
#include "core/base/random.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace espalier {
namespace {

using PlanePoints = std::vector<Eigen::Vector2d>;

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

FittedCircle meanCircle(const PlanePoints& points) {
  double sum = 0;
  for (const Eigen::Vector2d& point : points)
    sum += point.norm();
  return judgedCircle({0, 0}, sum / static_cast<double>(points.size()), points);
}

FittedCircle maximumCircle(const PlanePoints& points) {
  double most = 0;
  for (const Eigen::Vector2d& point : points)
    most = std::max(most, point.norm());
  return judgedCircle({0, 0}, most, points);
}

/// The circle through three points, if they are not on a line.
std::optional<std::pair<Eigen::Vector2d, double>>
circleThrough(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  const Eigen::Vector2d ab = b - a;
  const Eigen::Vector2d ac = c - a;
  const double area = 2 * cross(ab, ac);
  if (!(std::abs(area) > 1e-9 * (ab.squaredNorm() + ac.squaredNorm()))) return std::nullopt;
  const Eigen::Vector2d offset((ac.y() * ab.squaredNorm() - ab.y() * ac.squaredNorm()) / area,
                               (ab.x() * ac.squaredNorm() - ac.x() * ab.squaredNorm()) / area);
  return std::pair(Eigen::Vector2d(a + offset), offset.norm());
}

/// Median distance of points to a circle [L].
double medianDistance(const PlanePoints& points, const Eigen::Vector2d& center, double radius,
                      std::vector<double>& scratch) {
  scratch.clear();
  for (const Eigen::Vector2d& point : points)
    scratch.push_back(std::abs((point - center).norm() - radius));
  const auto middle = scratch.begin() + static_cast<std::ptrdiff_t>(scratch.size() / 2);
  std::nth_element(scratch.begin(), middle, scratch.end());
  return *middle;
}

/// The circle with the least median distance among circles through three of the points.
std::optional<FittedCircle> leastMedianCircle(const PlanePoints& points) {
  constexpr int draws = 150;          // half stray: all of them bad once in 10^9
  constexpr std::size_t judged = 128; // points are enough to compare circles
  PlanePoints some;
  const std::size_t step = std::max<std::size_t>(1, points.size() / judged);
  for (std::size_t i = 0; i < points.size(); i += step)
    some.push_back(points[i]);
  double farthest = 0;
  for (const Eigen::Vector2d& point : points)
    farthest = std::max(farthest, point.norm());
  Random random(1);
  std::vector<double> scratch;
  std::optional<std::pair<Eigen::Vector2d, double>> best;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < draws; ++i) {
    const std::size_t a = random.below(some.size());
    const std::size_t b = random.below(some.size());
    const std::size_t c = random.below(some.size());
    const auto circle = circleThrough(some[a], some[b], some[c]);
    if (!circle || circle->second > 2 * farthest) continue; // as good as a line
    const double median = medianDistance(some, circle->first, circle->second, scratch);
    if (median >= least) continue;
    least = median;
    best = circle;
  }
  if (!best) return std::nullopt;
  return judgedCircle(best->first, best->second, points);
}

std::optional<FittedCircle> robustCircle(const PlanePoints& points) {
  std::optional<FittedCircle> circle = leastMedianCircle(points);
  if (!circle) return std::nullopt;
  std::vector<double> scratch;
  PlanePoints kept;
  constexpr int rounds = 10;
  for (int i = 0; i < rounds; ++i) {
    constexpr double deviation = 1.4826; // per median distance, of normal noise
    constexpr double farthest = 2.5;     // in standard deviations
    constexpr double least = 0.01;       // of the radius: wood is no perfect circle
    const double scale =
        deviation * medianDistance(points, circle->center, circle->radius, scratch);
    const double limit = std::max(farthest * scale, least * circle->radius);
    PlanePoints next;
    for (const Eigen::Vector2d& point : points)
      if (std::abs((point - circle->center).norm() - circle->radius) <= limit)
        next.push_back(point);
    if (next == kept) break;
    kept = std::move(next);
    const std::optional<FittedCircle> better = fitCircle(kept);
    if (!better) return std::nullopt;
    circle = better;
  }
  if (2 * kept.size() < points.size()) return std::nullopt;
  constexpr double mostError = 0.3; // in radii, as for recentered()
  if (circle->error > mostError * circle->radius) return std::nullopt;
  return circle;
}

} // namespace

double leastCoverage(RadiusMeasure measure) {
  switch (measure) {
  case RadiusMeasure::hull:
    return 0.9;
  case RadiusMeasure::circle:
    return 0.3;
  case RadiusMeasure::mean:
  case RadiusMeasure::maximum:
    break;
  }
  return 0.45;
}

MeasuredCircle measuredCircle(const CrossSection& section, RadiusMeasure measure) {
  constexpr std::size_t fewest = 8;
  if (section.points.size() < fewest) return NoRadius::fewPoints;
  std::optional<FittedCircle> circle;
  switch (measure) {
  case RadiusMeasure::mean:
    circle = meanCircle(section.points);
    break;
  case RadiusMeasure::maximum:
    circle = maximumCircle(section.points);
    break;
  case RadiusMeasure::hull:
    circle = hullCircle(section.points);
    break;
  case RadiusMeasure::circle:
    circle = robustCircle(section.points);
    break;
  }
  if (!circle || !(circle->radius > 0)) return NoRadius::noCircle;
  if (circle->coverage < leastCoverage(measure)) return NoRadius::oneSided;
  return *circle;
}

std::optional<FittedCircle> hullCircle(const PlanePoints& points) {
  const PlanePoints hull = planeHull(points);
  if (hull.size() < 3) return std::nullopt;
  double perimeter = 0;
  double area = 0; // twice
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Eigen::Vector2d a = hull[i] - hull[0]; // near the hull: less is lost to rounding
    const Eigen::Vector2d b = hull[(i + 1) % hull.size()] - hull[0];
    perimeter += (b - a).norm();
    area += cross(a, b);
    moment += cross(a, b) * (a + b) / 3;
  }
  if (!(area > 1e-12 * perimeter * perimeter)) return std::nullopt;
  return judgedCircle(hull[0] + moment / area, perimeter / (2 * std::numbers::pi), points);
}

SectionRadii sectionRadii(const CrossSections& sections, const std::vector<NodeId>& nodes,
                          RadiusMeasure measure, const Progress& progress) {
  std::vector<MeasuredCircle> circles(nodes.size(), NoRadius::noSection);
  const auto look = [&](Eigen::Index i) {
    const std::optional<CrossSection> section = sections.at(nodes[static_cast<std::size_t>(i)]);
    if (section) circles[static_cast<std::size_t>(i)] = measuredCircle(*section, measure);
  };
  parallelFor(static_cast<Eigen::Index>(nodes.size()), look, progress, 8);
  SectionRadii result;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (const auto* circle = std::get_if<FittedCircle>(&circles[i]))
      result.radii.emplace_back(nodes[i], circle->radius);
    else
      ++result.refused[static_cast<std::size_t>(std::get<NoRadius>(circles[i]))];
  return result;
}

} // namespace espalier
