#include "core/radius/measured_radius.h"

#include "core/base/parallel.h"
#include "core/radius/cylinder_fit.h"
#include "core/skeleton/axes.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

/// A stretch of an axis about a node, and its points.
struct Stretch {
  std::vector<Eigen::Vector3d> points; // [L], frame of the skeleton
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
    double distances = 0;
    std::size_t first = at;
    std::size_t last = at;
    take(axis[at], result, distances);
    for (;;) {
      const double radius = meanOf(distances, result.points.size());
      const double length = (place(axis[last]) - place(axis[first])).norm();
      const bool isLong = length >= options_.length * radius && last > first;
      if (isLong && (result.points.size() >= enough || last - first >= 6)) break;
      const bool canRise = last + 1 < axis.size();
      if ((!canRise && first == 0) || result.points.size() >= most) break;
      const bool rises = canRise && (first == 0 || last - at <= at - first);
      take(rises ? axis[++last] : axis[--first], result, distances);
    }
    result.start.point = place(axis[at]);
    result.start.direction = directionOf(axis, first, last);
    result.start.radius = meanOf(distances, result.points.size());
    return result;
  }

private:
  [[nodiscard]] const Eigen::Vector3d& place(NodeId id) const { return skeleton_[id].position; }

  static double meanOf(double sum, std::size_t count) {
    return count > 0 ? sum / static_cast<double>(count) : 0;
  }

  void take(NodeId id, Stretch& stretch, double& distances) const {
    for (const std::uint32_t column : points_.of(id)) {
      stretch.points.push_back(points_.position(column));
      distances += points_.distance(column);
    }
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

/// The cylinder of a stretch, if its points tell of one.
std::optional<FittedCylinder> cylinderOf(const Stretch& stretch, const CylinderOptions& options) {
  if (!(stretch.start.radius > 0)) return std::nullopt;
  const std::optional<FittedCylinder> fit = fitCylinder(stretch.points, stretch.start);
  constexpr double leastKept = 2.0 / 3;
  constexpr double mostError = 0.3; // in radii
  constexpr double mostTurn = 0.7;  // cosine to the axis
  if (!fit || fit->coverage < options.leastCoverage || fit->kept < leastKept ||
      fit->error > mostError * fit->radius ||
      std::abs(fit->direction.dot(stretch.start.direction)) < mostTurn)
    return std::nullopt;
  return fit;
}

constexpr double widening = 0.1; // of wood by a beam, in spacings

MeasuredRadius radiusOf(const FittedCylinder& fit, double spacing) {
  constexpr double roughness = 0.04;
  const double scatter = fit.error / fit.radius / std::sqrt(fit.kept * fit.points / 5) /
                         (fit.coverage * fit.coverage); // five numbers are fitted
  return {.radius = fit.radius,
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

std::vector<MeasuredRadius> cylinderRadii(const Skeleton& skeleton, const AssignedPoints& points,
                                          const CylinderOptions& options,
                                          const Progress& progress) {
  std::vector<MeasuredRadius> result(skeleton.idEnd());
  const auto cylinders = cylindersAbout(skeleton, points, options, progress);
  for (std::size_t i = 0; i < cylinders.size(); ++i)
    if (cylinders[i]) result[i] = radiusOf(*cylinders[i], options.spacing);
  return result;
}

std::vector<MeasuredRadius> withThinRadii(const Skeleton& skeleton, const AssignedPoints& points,
                                          std::vector<MeasuredRadius> measured) {
  constexpr double deviation = 0.2;
  const std::vector<double> means = assignedRadii(skeleton, points, AssignedMeasure::mean);
  for (const NodeId id : skeleton.ids()) {
    MeasuredRadius& each = measured[indexOf(id)];
    const double mean = means[indexOf(id)];
    if (each.radius == 0 && mean > 0) each = {.radius = mean, .deviation = deviation};
  }
  return measured;
}

} // namespace espalier
