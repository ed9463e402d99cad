#include "core/radius/measured_radius.h"

#include "core/base/parallel.h"
#include "core/base/quantile.h"
#include "core/radius/cylinder_fit.h"
#include "core/skeleton/axes.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

/// A stretch of an axis about a node, and its points.
struct Stretch {
  std::vector<Eigen::Vector3d> points; // [L], frame of the skeleton
  std::vector<double> distances;       // of these to the axis [L]
  FittedCylinder start;
};

/// Gathers the points of nodes around one of an axis.
class StretchFinder {
public:
  StretchFinder(const Skeleton& skeleton, const AssignedPoints& points,
                const CylinderOptions& options)
      : skeleton_(skeleton), points_(points), options_(options) {}

  [[nodiscard]] Stretch about(const Axis& axis, std::size_t at) const {
    if (points_.of(axis[at]).empty()) return {};
    constexpr std::size_t enough = 24; // points
    constexpr std::size_t most = 400;  // more do not make it better
    Stretch result;
    double sum = 0;
    std::size_t first = at;
    std::size_t last = at;
    sum += take(axis[at], result);
    for (;;) {
      const double radius =
          sum / static_cast<double>(std::max<std::size_t>(1, result.points.size()));
      const double length = (place(axis[last]) - place(axis[first])).norm();
      const bool isLong = length >= options_.length * radius && last > first;
      if (isLong && (result.points.size() >= enough || last - first >= 6)) break;
      const bool canRise = last + 1 < axis.size();
      if ((!canRise && first == 0) || result.points.size() >= most) break;
      const bool rises = canRise && (first == 0 || last - at <= at - first);
      sum += take(rises ? axis[++last] : axis[--first], result);
    }
    result.start.point = place(axis[at]);
    result.start.direction = directionOf(axis, first, last);
    result.start.radius = quantile(result.distances, 0.25).value_or(0); // needles lie farther out
    return result;
  }

private:
  [[nodiscard]] const Eigen::Vector3d& place(NodeId id) const { return skeleton_[id].position; }

  /// @return the sum of the distances to the axis [L]
  double take(NodeId id, Stretch& stretch) const {
    double sum = 0;
    for (const std::uint32_t column : points_.of(id)) {
      stretch.points.push_back(points_.position(column));
      stretch.distances.push_back(points_.distance(column));
      sum += stretch.distances.back();
    }
    return sum;
  }

  /// Of the wood from one node of an axis to another; upright if that has no length.
  [[nodiscard]] Eigen::Vector3d directionOf(const Axis& axis, std::size_t first,
                                            std::size_t last) const {
    const NodeId below =
        first > 0 ? axis[first - 1] : skeleton_[axis[first]].parent.value_or(axis[first]);
    const Eigen::Vector3d along = place(axis[last]) - place(below);
    const double length = along.norm();
    return length > 0 ? Eigen::Vector3d(along / length) : Eigen::Vector3d::UnitZ();
  }

  const Skeleton& skeleton_;
  const AssignedPoints& points_;
  CylinderOptions options_;
};

/// The cylinder of a stretch, if its points show one.
std::optional<FittedCylinder> cylinderOf(const Stretch& stretch, const CylinderOptions& options) {
  if (!(stretch.start.radius > 0)) return std::nullopt;
  std::optional<FittedCylinder> fit = fitCylinder(stretch.points, stretch.start);
  constexpr double leastKept = 2.0 / 3;
  constexpr double mostError = 0.3; // in radii
  constexpr double mostTurn = 0.7;  // cosine to the axis
  if (!fit || fit->coverage < options.leastCoverage || fit->kept < leastKept ||
      fit->error > mostError * fit->radius ||
      std::abs(fit->direction.dot(stretch.start.direction)) < mostTurn)
    return std::nullopt;
  return fit;
}

constexpr double widening = 0.1;   // of wood by a beam, in spacings
constexpr double roughness = 0.04; // by which wood is no cylinder, of its radius

MeasuredRadius radiusOf(const FittedCylinder& fit, double spacing) {
  const double scatter = fit.error / fit.radius / std::sqrt(fit.kept * fit.points / 5) /
                         (fit.coverage * fit.coverage); // five numbers are fitted
  // Scattered points lie farther out than in: the least squares are that much too thick.
  return {.radius = fit.radius - fit.error * fit.error / (2 * fit.radius),
          .deviation = std::hypot(roughness, scatter, widening * spacing / fit.radius)};
}

} // namespace

std::vector<std::optional<FittedCylinder>> cylindersAbout(const Skeleton& skeleton,
                                                          const AssignedPoints& points,
                                                          const CylinderOptions& options,
                                                          const Progress& progress) {
  std::vector<std::optional<FittedCylinder>> result(skeleton.idEnd());
  const std::vector<Axis> all = axes(skeleton);
  std::vector<std::pair<std::size_t, std::size_t>> places; // axis, node on it
  for (std::size_t a = 0; a < all.size(); ++a)
    for (std::size_t i = 0; i < all[a].size(); ++i)
      places.emplace_back(a, i);
  const StretchFinder finder(skeleton, points, options);
  const auto measure = [&](Eigen::Index i) {
    const auto [axis, at] = places[static_cast<std::size_t>(i)];
    result[indexOf(all[axis][at])] = cylinderOf(finder.about(all[axis], at), options);
  };
  parallelFor(static_cast<Eigen::Index>(places.size()), measure, progress, 16);
  return result;
}

double pointError(const std::vector<std::optional<FittedCylinder>>& cylinders) {
  constexpr double thick = 5; // errors
  constexpr double leastCoverage = 0.5;
  std::vector<double> errors;
  for (const auto& each : cylinders)
    if (each && each->radius > thick * each->error && each->coverage >= leastCoverage)
      errors.push_back(each->error);
  if (errors.empty()) return 0;
  const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
  std::nth_element(errors.begin(), middle, errors.end());
  return *middle;
}

std::vector<std::optional<FittedCylinder>>
withoutScattered(std::vector<std::optional<FittedCylinder>> cylinders, double error) {
  constexpr double most = 1.5;
  for (std::optional<FittedCylinder>& each : cylinders)
    if (each && error > 0 && each->error > most * std::hypot(error, roughness * each->radius))
      each.reset();
  return cylinders;
}

std::vector<MeasuredRadius>
cylinderRadii(const std::vector<std::optional<FittedCylinder>>& cylinders, double spacing) {
  std::vector<MeasuredRadius> result(cylinders.size());
  for (std::size_t i = 0; i < cylinders.size(); ++i)
    if (cylinders[i]) result[i] = radiusOf(*cylinders[i], spacing);
  return result;
}

namespace {

/// Distances to the axis [L] of the points of a node, and of those next to it until there are
/// enough; none if it has under 3 of its own.
std::vector<double> distancesAbout(const AssignedPoints& points, const Axis& axis, std::size_t at) {
  constexpr std::size_t fewest = 3;
  constexpr std::size_t enough = 12;
  constexpr std::size_t reach = 4; // nodes
  std::vector<double> distances;
  const auto take = [&](std::size_t i) {
    for (const std::uint32_t column : points.of(axis[i]))
      distances.push_back(points.distance(column));
  };
  take(at);
  if (distances.size() < fewest) return {};
  for (std::size_t step = 1; step <= reach && distances.size() < enough; ++step) {
    if (at + step < axis.size()) take(at + step);
    if (at >= step) take(at - step);
  }
  return distances;
}

} // namespace

std::vector<MeasuredRadius> withThinRadii(const Skeleton& skeleton, const AssignedPoints& points,
                                          std::vector<MeasuredRadius> measured, double error) {
  constexpr double deviation = 0.2;
  constexpr double tenth = 0.1;
  const double half = 1.2816 / 2 * error; // of what the tenth of normal noise is under its middle
  for (const Axis& axis : axes(skeleton))
    for (std::size_t at = 0; at < axis.size(); ++at) {
      MeasuredRadius& each = measured[indexOf(axis[at])];
      if (each.radius > 0) continue;
      const std::vector<double> distances = distancesAbout(points, axis, at);
      if (distances.empty()) continue;
      const double low = quantile(distances, tenth).value_or(0) + half;
      const double square = low * low - error * error; // scatter along the surface
      const double radius = half + std::sqrt(std::max(0.0, square));
      if (radius > 0) each = {.radius = radius, .deviation = deviation};
    }
  return measured;
}

} // namespace espalier
