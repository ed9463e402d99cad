#include "core/clean/wire.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>

namespace espalier {
namespace {

/// A catenary above a level line from one place to another; u along it, w beside it, z up [L].
struct Catenary {
  Eigen::Vector3d start = Eigen::Vector3d::Zero();  // [L]
  Eigen::Vector2d ahead = Eigen::Vector2d::UnitX(); // unit, level
  double span = 1;                                  // [L], level
  // What is fitted: heights and places beside the line at both ends, and how bent it is (span by
  // the radius at its lowest point).
  double startHeight = 0, endHeight = 0, startAside = 0, endAside = 0, bend = 0;

  [[nodiscard]] Eigen::Vector3d local(const Eigen::Vector3d& place) const {
    const Eigen::Vector3d d = place - start;
    return {d.head<2>().dot(ahead), ahead.x() * d.y() - ahead.y() * d.x(), d.z()};
  }
  [[nodiscard]] Eigen::Vector3d at(double u) const {
    const double w = aside(u);
    return start +
           Eigen::Vector3d(u * ahead.x() - w * ahead.y(), u * ahead.y() + w * ahead.x(), height(u));
  }
  [[nodiscard]] double aside(double u) const {
    return startAside + (endAside - startAside) * u / span;
  }
  [[nodiscard]] double lowest() const { // place of the lowest point, times bend / span
    const double rise = (endHeight - startHeight) / span;
    const double half = bend < 1e-6 ? 1 : bend / 2 / std::sinh(bend / 2);
    return bend / 2 - std::asinh(rise * half);
  }
  [[nodiscard]] double height(double u) const {
    const double s = u / span;
    if (bend < 1e-6) return startHeight + (endHeight - startHeight) * s;
    return startHeight +
           2 * span / bend * std::sinh(bend * s / 2 - lowest()) * std::sinh(bend * s / 2);
  }
  [[nodiscard]] double slope(double u) const { return std::sinh(bend * u / span - lowest()); }
  /// Distances beside and across the curve, up positive.
  [[nodiscard]] Eigen::Vector2d off(const Eigen::Vector3d& point) const {
    const double steep = slope(point.x());
    return {point.y() - aside(point.x()),
            (point.z() - height(point.x())) / std::sqrt(1 + steep * steep)};
  }
};

/// The bend that hangs by a share of a level span.
double bendFor(double sag) {
  double low = 0;
  double high = 12;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    const bool isMore = middle > 1e-9 && (std::cosh(middle / 2) - 1) / middle > sag;
    (isMore ? high : low) = middle;
  }
  return low;
}

/// Share of [from, to] that has points on the curve.
double filledOf(const Catenary& curve, const std::vector<Eigen::Vector3d>& points, double from,
                double to, double tolerance) {
  const double width = std::max(2 * tolerance, (to - from) / 400);
  const auto count = static_cast<std::size_t>(std::ceil((to - from) / width));
  if (count == 0) return 0;
  std::vector<char> has(count, 0);
  for (const Eigen::Vector3d& point : points)
    if (point.x() >= from && point.x() < to && curve.off(point).norm() <= tolerance)
      has[std::min(static_cast<std::size_t>((point.x() - from) / width), count - 1)] = 1;
  return static_cast<double>(std::ranges::count(has, 1)) / static_cast<double>(count);
}

/// The bend with which most of the span has points, ends as they are.
void chooseBend(Catenary& curve, const std::vector<Eigen::Vector3d>& points,
                const WireOptions& options, const Progress& progress) {
  const double sags = options.mostSag * curve.span / options.width();
  const int count = std::clamp(static_cast<int>(std::ceil(sags)), 8, 400);
  double most = -1;
  Catenary tried = curve;
  for (int i = 0; i <= count; ++i) {
    progress.check();
    tried.bend = bendFor(options.mostSag * i / count);
    const double filled = filledOf(tried, points, 0, curve.span, 1.5 * options.width());
    if (filled <= most) continue;
    most = filled;
    curve = tried;
  }
}

/// One step of Gauss and Newton with Tukey's weights over the points in [from, to].
void refine(Catenary& curve, const std::vector<Eigen::Vector3d>& points, double from, double to,
            double reach) {
  Eigen::Matrix<double, 5, 5> sums = Eigen::Matrix<double, 5, 5>::Identity() * 1e-9;
  Eigen::Matrix<double, 5, 1> right = Eigen::Matrix<double, 5, 1>::Zero();
  double Catenary::*const fitted[] = {&Catenary::startHeight, &Catenary::endHeight,
                                      &Catenary::bend};
  const double steps[] = {1e-4 * curve.span, 1e-4 * curve.span, 1e-4};
  std::array<Catenary, 3> moved{curve, curve, curve};
  for (std::size_t k = 0; k < 3; ++k)
    moved[k].*fitted[k] += steps[k];
  for (const Eigen::Vector3d& point : points) {
    if (point.x() < from || point.x() > to) continue;
    const Eigen::Vector2d off = curve.off(point);
    const double share = off.norm() / reach;
    if (share >= 1) continue;
    const double weight = (1 - share * share) * (1 - share * share);
    Eigen::Matrix<double, 5, 1> across = Eigen::Matrix<double, 5, 1>::Zero();
    for (std::size_t k = 0; k < 3; ++k)
      across[static_cast<Eigen::Index>(k)] = (moved[k].off(point).y() - off.y()) / steps[k];
    const double s = point.x() / curve.span;
    Eigen::Matrix<double, 5, 1> beside = Eigen::Matrix<double, 5, 1>::Zero();
    beside[3] = s - 1;
    beside[4] = -s;
    sums += weight * (across * across.transpose() + beside * beside.transpose());
    right -= weight * (across * off.y() + beside * off.x());
  }
  const Eigen::Matrix<double, 5, 1> step = sums.ldlt().solve(right);
  if (!step.allFinite()) return;
  curve.startHeight += step[0];
  curve.endHeight += step[1];
  curve.bend = std::clamp(curve.bend + step[2], 0.0, 12.0);
  curve.startAside += step[3];
  curve.endAside += step[4];
}

/// As far as points go on, no gap wider than allowed, by `most` at each end at most.
std::pair<double, double> followedEnds(const Catenary& curve,
                                       const std::vector<Eigen::Vector3d>& points, double from,
                                       double to, double most, const WireOptions& options) {
  std::vector<double> places;
  for (const Eigen::Vector3d& point : points)
    if (curve.off(point).norm() <= options.width()) places.push_back(point.x());
  std::ranges::sort(places);
  const double least = from - most;
  const double last = to + most;
  for (auto at = std::ranges::lower_bound(places, to);
       at != places.end() && *at <= last && *at - to <= options.gap; ++at)
    to = *at;
  for (auto at = std::make_reverse_iterator(std::ranges::lower_bound(places, from));
       at != places.rend() && *at >= least && from - *at <= options.gap; ++at)
    from = *at;
  return {from, to};
}

double depthBelowChord(const Catenary& curve, double from, double to) {
  double most = 0;
  for (int i = 1; i < 50; ++i) {
    const double share = i / 50.0;
    const double chord = (1 - share) * curve.height(from) + share * curve.height(to);
    most = std::max(most, chord - curve.height(from + share * (to - from)));
  }
  return most;
}

Wire wireFrom(const Catenary& curve, const std::vector<Eigen::Vector3d>& points,
              const std::vector<Eigen::Index>& columns, double from, double to,
              const WireOptions& options) {
  Wire wire{.from = curve.at(from),
            .to = curve.at(to),
            .sag = depthBelowChord(curve, from, to),
            .error = 0,
            .filled = filledOf(curve, points, from, to, options.width()),
            .points = {}};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points[i].x();
    if (x < from - options.width() || x > to + options.width()) continue;
    const double off = curve.off(points[i]).norm();
    if (off > options.width()) continue;
    wire.points.push_back(columns[i]);
    wire.error += off * off;
  }
  if (!wire.points.empty())
    wire.error = std::sqrt(wire.error / static_cast<double>(wire.points.size()));
  return wire;
}

} // namespace

WireOptions resolved(WireOptions options, const PlantScale& scale) {
  for (Length WireOptions::*length :
       {&WireOptions::tolerance, &WireOptions::noise, &WireOptions::gap, &WireOptions::leastLength})
    options.*length = lengthAt(options.*length, scale);
  return options;
}

std::optional<Wire> wireBetween(const Eigen::Matrix3Xf& all, const Eigen::Vector3d& a,
                                const Eigen::Vector3d& b, const WireOptions& options,
                                const Progress& progress) {
  Catenary curve{.start = a, .endHeight = (b - a).z()};
  curve.span = (b - a).head<2>().norm();
  if (curve.span <= 2 * options.width()) return std::nullopt;
  curve.ahead = (b - a).head<2>() / curve.span;
  const double sag = options.mostSag * curve.span;
  const double low = std::min(0.0, curve.endHeight) - sag;
  const double high = std::max(0.0, curve.endHeight);
  std::vector<Eigen::Vector3d> points; // in the frame of the curve
  std::vector<Eigen::Index> columns;
  const double slack = 6 * options.width();
  for (Eigen::Index i = 0; i < all.cols(); ++i) {
    const Eigen::Vector3d point = curve.local(all.col(i).cast<double>());
    const double outside = std::max({0.0, -point.x(), point.x() - curve.span});
    if (std::abs(point.y()) > slack + 0.05 * outside) continue;
    if (outside == 0 && (point.z() < low - slack || point.z() > high + slack)) continue;
    points.push_back(point);
    columns.push_back(i);
  }
  progress.update(0.2);
  chooseBend(curve, points, options, progress.part(0.2, 0.6));
  double from = 0;
  double to = curve.span;
  for (int i = 0; i < 10; ++i)
    refine(curve, points, from, to, (i < 4 ? 4 : 2) * options.width());
  if (filledOf(curve, points, from, to, options.width()) < 0.5) return std::nullopt;
  for (int round = 0; round < 12; ++round) {
    progress.update(0.6 + 0.4 * round / 12);
    const auto [lower, upper] = followedEnds(curve, points, from, to, (to - from) / 2, options);
    const bool isDone = upper - lower <= to - from + options.width();
    from = lower;
    to = upper;
    for (int i = 0; i < 4; ++i)
      refine(curve, points, from, to, 2 * options.width());
    if (isDone) break;
  }
  return wireFrom(curve, points, columns, from, to, options);
}

PointSet wirePointsBetween(const PointCloud& cloud, const PointSet& leftOut, UpAxis up,
                           const PlantScale& scale, const Eigen::Vector3d& a,
                           const Eigen::Vector3d& b, const WireOptions& options,
                           const Progress& progress) {
  const StandingPoints standing = standingPoints(cloud, leftOut, up);
  const std::optional<Wire> wire =
      wireBetween(standing.positions, standing.fromFile(a), standing.fromFile(b),
                  resolved(options, scale), progress);
  return wire ? standing.inCloud(wire->points) : PointSet();
}

} // namespace espalier
