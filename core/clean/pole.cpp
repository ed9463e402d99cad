#include "core/clean/pole.h"

#include "core/base/circle_fit.h"
#include "core/base/quantile.h"
#include "core/base/random.h"
#include "core/graph/normals.h"
#include "core/radius/cylinder_fit.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace espalier {
namespace {

constexpr std::size_t mostFitted = 3000; // points that a cylinder is fitted to

double awayFrom(const FittedCylinder& pole, const Eigen::Vector3d& place) {
  const Eigen::Vector3d d = place - pole.point;
  return (d - d.dot(pole.direction) * pole.direction).norm();
}

double along(const FittedCylinder& pole, const Eigen::Vector3d& place) {
  return (place - pole.point).dot(pole.direction);
}

/// Some of all, evenly.
std::vector<Eigen::Vector3d> someEvenly(const std::vector<Eigen::Vector3d>& all) {
  const std::size_t step = all.size() / mostFitted + 1;
  std::vector<Eigen::Vector3d> some;
  for (std::size_t i = 0; i < all.size(); i += step)
    some.push_back(all[i]);
  return some;
}

/// Draws cylinders through points around a place.
class PoleDraws {
public:
  PoleDraws(std::vector<Eigen::Vector3d> points, const Eigen::Vector3d& place,
            const PoleOptions& options)
      : points_(std::move(points)), place_(place), options_(options), random_(options.seed) {
    Eigen::Matrix3Xf local(3, std::ssize(points_));
    for (std::size_t i = 0; i < points_.size(); ++i)
      local.col(static_cast<Eigen::Index>(i)) = (points_[i] - place).cast<float>();
    normals_ = normals(local, nearestNeighborhoods(local, 10));
    const Eigen::Vector3f mean = local.rowwise().mean();
    const Eigen::Matrix3f spread = (local.colwise() - mean) * (local.colwise() - mean).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread.cast<double>());
    usual_ = {Eigen::Vector3d::UnitZ(), axes.eigenvectors().col(2)};
  }

  std::optional<FittedCylinder> best(const Progress& progress) {
    std::optional<FittedCylinder> found;
    for (int i = 0; i < options_.trials; ++i) {
      progress.check();
      const std::optional<FittedCylinder> drawn = i % 2 == 0 ? byNormals() : byCircle(i / 2);
      if (drawn && isAllowed(*drawn) && (!found || score(*drawn) > found->points)) {
        found = drawn;
        found->points = score(*drawn);
      }
    }
    return found;
  }

  [[nodiscard]] bool isAllowed(const FittedCylinder& pole) const {
    return pole.radius > 0 && pole.radius <= options_.mostRadius &&
           std::abs(pole.direction.z()) >= std::cos(options_.mostLean) &&
           awayFrom(pole, place_) <= pole.radius + 3 * options_.width();
  }

  [[nodiscard]] std::vector<Eigen::Vector3d> onWall(const FittedCylinder& pole,
                                                    double tolerance) const {
    std::vector<Eigen::Vector3d> found;
    for (const Eigen::Vector3d& point : points_)
      if (std::abs(awayFrom(pole, point) - pole.radius) <= tolerance) found.push_back(point);
    return found;
  }

private:
  /// Points on the wall, less those within: scanned poles are hollow.
  [[nodiscard]] double score(const FittedCylinder& pole) const {
    double sum = 0;
    for (const Eigen::Vector3d& point : points_) {
      const double off = awayFrom(pole, point) - pole.radius;
      if (std::abs(off) <= options_.width()) ++sum;
      if (off < -2 * options_.width()) --sum;
    }
    return sum;
  }

  std::size_t draw() { return random_.below(points_.size()); }

  /// The axis is across both normals, and met by both.
  std::optional<FittedCylinder> byNormals() {
    const std::size_t a = draw();
    const std::size_t b = draw();
    const Eigen::Vector3d na = normals_.col(static_cast<Eigen::Index>(a)).cast<double>();
    const Eigen::Vector3d nb = normals_.col(static_cast<Eigen::Index>(b)).cast<double>();
    Eigen::Vector3d direction = na.cross(nb);
    if (direction.norm() < 0.2) return std::nullopt;
    direction.normalize();
    const Eigen::Vector3d inPlane = direction.cross(nb); // across nb and the axis
    const double across = na.dot(inPlane);
    if (std::abs(across) < 0.1) return std::nullopt;
    const double reach = (points_[b] - points_[a]).dot(inPlane) / across;
    const Eigen::Vector3d center = points_[a] + reach * na;
    FittedCylinder pole{.point = center, .direction = upward(direction)};
    pole.radius = (awayFrom(pole, points_[a]) + awayFrom(pole, points_[b])) / 2;
    return pole;
  }

  /// A circle through three points across a direction.
  std::optional<FittedCylinder> byCircle(int trial) {
    const Eigen::Vector3d direction = usual_[static_cast<std::size_t>(trial) % usual_.size()];
    const Eigen::Vector3d x = direction.unitOrthogonal();
    const Eigen::Vector3d y = direction.cross(x);
    std::vector<Eigen::Vector2d> three;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d d = points_[draw()] - place_;
      three.emplace_back(d.dot(x), d.dot(y));
    }
    const std::optional<FittedCircle> circle = fitCircle(three);
    if (!circle) return std::nullopt;
    return FittedCylinder{.point = place_ + circle->center.x() * x + circle->center.y() * y,
                          .direction = upward(direction),
                          .radius = circle->radius};
  }

  static Eigen::Vector3d upward(const Eigen::Vector3d& direction) {
    return direction.z() < 0 ? Eigen::Vector3d(-direction) : direction;
  }

  std::vector<Eigen::Vector3d> points_;
  Eigen::Vector3d place_;
  const PoleOptions& options_;
  Random random_;
  Eigen::Matrix3Xf normals_;
  std::array<Eigen::Vector3d, 2> usual_;
};

/// How far a pole goes on from a place along it.
struct PoleEnds {
  double low = 0, high = 0; // [L] along its direction
  [[nodiscard]] double length() const { return high - low; }
};

/// The points that a pole through a place can have, as leaning as it may be.
std::vector<Eigen::Index> pointsInCone(const Eigen::Matrix3Xf& points, const Eigen::Vector3d& place,
                                       const PoleOptions& options) {
  const double slope = std::tan(std::min(options.mostLean + 0.05, 1.5));
  const double wide = 2 * options.mostRadius + 6 * options.width();
  std::vector<Eigen::Index> found;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3d d = points.col(i).cast<double>() - place;
    const double limit = wide + slope * std::abs(d.z());
    if (d.head<2>().squaredNorm() <= limit * limit) found.push_back(i);
  }
  return found;
}

/// From `start` along sorted places as far as no gap is wider than `gap`, within [least, most].
PoleEnds followed(const std::vector<double>& sorted, const PoleEnds& start, double gap,
                  double least, double most) {
  PoleEnds ends = start;
  for (auto at = std::ranges::lower_bound(sorted, start.high);
       at != sorted.end() && *at <= most && *at - ends.high <= gap; ++at)
    ends.high = *at;
  for (auto at = std::make_reverse_iterator(std::ranges::lower_bound(sorted, start.low));
       at != sorted.rend() && *at >= least && ends.low - *at <= gap; ++at)
    ends.low = *at;
  return ends;
}

/// Fits a pole further and further up and down.
struct GrownPole {
  FittedCylinder pole;
  PoleEnds ends;
};

GrownPole grow(FittedCylinder pole, const Eigen::Vector3d& place,
               const std::vector<Eigen::Vector3d>& near, const PoleOptions& options,
               const Progress& progress) {
  Eigen::Vector3d middle = place;
  PoleEnds ends{-options.width() / 2, options.width() / 2};
  for (int round = 0; round < 16; ++round) {
    progress.check();
    pole.point += along(pole, middle) * pole.direction; // ends count from the middle
    std::vector<double> sorted;
    for (const Eigen::Vector3d& point : near)
      if (std::abs(awayFrom(pole, point) - pole.radius) <= options.width())
        sorted.push_back(along(pole, point));
    std::ranges::sort(sorted);
    const double step = std::max<double>(options.reach, ends.length() / 2);
    const PoleEnds next = followed(sorted, ends, options.gap, ends.low - step, ends.high + step);
    const bool isDone = next.length() <= ends.length() + options.width() / 4;
    ends = next;
    std::vector<Eigen::Vector3d> wall;
    for (const Eigen::Vector3d& point : near) {
      const double t = along(pole, point);
      if (t >= ends.low && t <= ends.high &&
          std::abs(awayFrom(pole, point) - pole.radius) <= 1.5 * options.width())
        wall.push_back(point);
    }
    const Eigen::Vector3d from = pole.point;
    if (const auto fitted = fitCylinder(someEvenly(wall), pole);
        fitted && fitted->radius <= options.mostRadius &&
        std::abs(fitted->direction.z()) >= std::cos(options.mostLean)) {
      pole = *fitted;
      if (pole.direction.z() < 0) pole.direction = -pole.direction;
    }
    middle = from;
    pole.point += along(pole, middle) * pole.direction;
    if (isDone && round > 0) break;
  }
  return {pole, ends};
}

Pole poleFrom(const GrownPole& grown, const Eigen::Matrix3Xf& points,
              const std::vector<Eigen::Index>& columns, const PoleOptions& options) {
  Pole pole{.foot = grown.pole.point + grown.ends.low * grown.pole.direction,
            .top = grown.pole.point + grown.ends.high * grown.pole.direction,
            .radius = grown.pole.radius,
            .error = grown.pole.error,
            .points = {}};
  for (const Eigen::Index column : columns) {
    const Eigen::Vector3d point = points.col(column).cast<double>();
    const double t = along(grown.pole, point);
    if (t >= grown.ends.low - options.width() && t <= grown.ends.high + options.width() &&
        awayFrom(grown.pole, point) <= pole.radius + options.width())
      pole.points.push_back(column);
  }
  return pole;
}

} // namespace

PoleOptions resolved(PoleOptions options, const PlantScale& scale) {
  for (Length PoleOptions::*length :
       {&PoleOptions::tolerance, &PoleOptions::noise, &PoleOptions::mostRadius, &PoleOptions::reach,
        &PoleOptions::gap, &PoleOptions::leastLength})
    options.*length = lengthAt(options.*length, scale);
  return options;
}

std::optional<Pole> poleAt(const Eigen::Matrix3Xf& points, const Eigen::Vector3d& place,
                           const PoleOptions& options, const Progress& progress) {
  constexpr std::size_t fewest = 12;
  const std::vector<Eigen::Index> columns = pointsInCone(points, place, options);
  std::vector<Eigen::Vector3d> near;
  std::vector<Eigen::Vector3d> around;
  for (const Eigen::Index column : columns) {
    near.emplace_back(points.col(column).cast<double>());
    if ((near.back() - place).norm() <= options.reach) around.push_back(near.back());
  }
  if (around.size() < fewest) return std::nullopt;
  PoleDraws draws(someEvenly(around), place, options);
  std::optional<FittedCylinder> pole = draws.best(progress.part(0, 0.6));
  if (!pole || pole->points < static_cast<double>(fewest)) return std::nullopt;
  if (const auto fitted = fitCylinder(draws.onWall(*pole, 2 * options.width()), *pole);
      fitted && draws.isAllowed(*fitted))
    pole = fitted;
  if (pole->direction.z() < 0) pole->direction = -pole->direction;
  const GrownPole grown = grow(*pole, place, near, options, progress.part(0.6, 1));
  Pole result = poleFrom(grown, points, columns, options);
  if (result.points.size() < fewest || grown.ends.length() < 2 * result.radius) return std::nullopt;
  progress.update(1);
  return result;
}

PointSet polePointsAt(const PointCloud& cloud, const PointSet& leftOut, UpAxis up,
                      const PlantScale& scale, const Eigen::Vector3d& place,
                      const PoleOptions& options, const Progress& progress) {
  const StandingPoints standing = standingPoints(cloud, leftOut, up);
  const std::optional<Pole> pole =
      poleAt(standing.positions, standing.fromFile(place), resolved(options, scale), progress);
  return pole ? standing.inCloud(pole->points) : PointSet();
}

} // namespace espalier
