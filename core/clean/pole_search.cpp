#include "core/base/parallel.h"
#include "core/base/quantile.h"
#include "core/clean/pole.h"
#include "core/cloud/voxels.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

/// Whether a cube and those beside it hold most of the points at their height.
bool standsFree(const Voxels& voxels, std::size_t cube) {
  constexpr std::size_t asMany = 4;
  const Voxels::Place center = voxels.place(cube);
  std::size_t block = 0;
  std::size_t ring = 0;
  for (int dy = -3; dy <= 3; ++dy)
    for (int dx = -3; dx <= 3; ++dx) {
      const auto found = voxels.find(center + Voxels::Place(dx, dy, 0));
      if (!found) continue;
      const bool isNear = std::abs(dx) <= 1 && std::abs(dy) <= 1;
      (isNear ? block : ring) += voxels.members(*found).size();
    }
  return asMany * ring <= block;
}

/// The cubes that stand free and touch each other, from `first` on.
std::vector<std::size_t> columnFrom(std::size_t first, const Voxels& voxels,
                                    std::vector<char>& isFree) {
  std::vector<std::size_t> column = {first};
  isFree[first] = 0;
  for (std::size_t next = 0; next < column.size(); ++next) {
    const Voxels::Place at = voxels.place(column[next]);
    for (int dz = -1; dz <= 1; ++dz)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const auto found = voxels.find(at + Voxels::Place(dx, dy, dz));
          if (!found || !isFree[*found]) continue;
          isFree[*found] = 0;
          column.push_back(*found);
        }
  }
  return column;
}

/// The mean of the points in the middle third of a column; none if it is lower than `least`.
std::optional<Eigen::Vector3d> middleOf(const std::vector<std::size_t>& column,
                                        const Voxels& voxels, const Eigen::Matrix3Xf& points,
                                        double least) {
  int low = voxels.place(column.front()).z();
  int high = low;
  for (const std::size_t cube : column) {
    low = std::min(low, voxels.place(cube).z());
    high = std::max(high, voxels.place(cube).z());
  }
  if ((high - low + 1) * voxels.edge() < least) return std::nullopt;
  const int middle = (low + high) / 2;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0;
  for (const std::size_t cube : column) {
    if (std::abs(voxels.place(cube).z() - middle) > (high - low) / 12) continue;
    for (const std::uint32_t member : voxels.members(cube)) {
      sum += points.col(member).cast<double>();
      ++count;
    }
  }
  if (count == 0) return std::nullopt;
  return sum / count;
}

double distanceToAxis(const Pole& pole, const Eigen::Vector3d& point) {
  const Eigen::Vector3d direction = (pole.top - pole.foot).normalized();
  const Eigen::Vector3d d = point - pole.foot;
  return (d - d.dot(direction) * direction).norm();
}

bool isIn(const Pole& pole, const Eigen::Vector3d& place, double tolerance) {
  const Eigen::Vector3d direction = (pole.top - pole.foot).normalized();
  const double along = (place - pole.foot).dot(direction);
  return along >= 0 && along <= (pole.top - pole.foot).norm() &&
         distanceToAxis(pole, place) <= pole.radius + tolerance;
}

/// As thick above as below.
bool isEven(const Pole& pole, const Eigen::Matrix3Xf& points, const PoleOptions& options) {
  const Eigen::Vector3d direction = (pole.top - pole.foot).normalized();
  const double length = (pole.top - pole.foot).norm();
  std::vector<double> below;
  std::vector<double> above;
  for (const Eigen::Index column : pole.points) {
    const Eigen::Vector3d point = points.col(column).cast<double>();
    const double share = (point - pole.foot).dot(direction) / length;
    if (share < 0.35 && share > 0.05) below.push_back(distanceToAxis(pole, point));
    if (share > 0.65 && share < 0.95) above.push_back(distanceToAxis(pole, point));
  }
  const auto low = quantile(std::move(below), 0.5);
  const auto high = quantile(std::move(above), 0.5);
  return low && high &&
         std::abs(*low - *high) <= std::max(0.12 * pole.radius, 0.15 * options.width());
}

/// Most of its length has points on the wall, and few beside it.
bool isBareWall(const Pole& pole, const Eigen::Matrix3Xf& points, const PoleOptions& options) {
  constexpr double wanted = 0.75; // share of slices
  const Eigen::Vector3d direction = (pole.top - pole.foot).normalized();
  const double length = (pole.top - pole.foot).norm();
  const double slice = std::max(2 * options.width(), length / 100);
  const auto slices = static_cast<std::size_t>(length / slice) + 1;
  std::vector<double> onWall(slices, 0);
  std::vector<double> beside(slices, 0);
  const double wide = 2 * pole.radius + 6 * options.width();
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3d d = points.col(i).cast<double>() - pole.foot;
    const double t = d.dot(direction);
    if (t < 0 || t > length) continue;
    const double away = (d - t * direction).norm();
    if (away > wide) continue;
    (away <= pole.radius + options.width() ? onWall
                                           : beside)[static_cast<std::size_t>(t / slice)] += 1;
  }
  const double usual = *quantile(onWall, 0.5);
  std::size_t bare = 0;
  for (std::size_t i = 0; i < slices; ++i)
    if (onWall[i] > 0.15 * usual && 4 * beside[i] <= onWall[i]) ++bare;
  return static_cast<double>(bare) >= wanted * static_cast<double>(slices);
}

/// Nothing goes on beyond an end: what is there ends soon, as does a wire that is fixed to it, or
/// is so little that it is twigs beside it.
bool endsFree(const Eigen::Vector3d& end, const Eigen::Vector3d& away, const Pole& pole,
              const Eigen::Matrix3Xf& points, const PoleOptions& options) {
  constexpr double beyond = 0.2;  // of its length
  constexpr double allowed = 0.4; // of that
  constexpr double opening = 0.5; // branches of a fork go on within such a cone
  constexpr double least = 0.15;  // of the points of the pole in a slice
  const double length = beyond * (pole.top - pole.foot).norm();
  const double wide = 2 * pole.radius + 4 * options.width();
  const double slice = 2 * options.width();
  const double few =
      least * slice * static_cast<double>(pole.points.size()) / (pole.top - pole.foot).norm();
  std::vector<std::size_t> held(static_cast<std::size_t>(std::ceil(length / slice)) + 1, 0);
  const double most = std::hypot(length, wide + opening * length);
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    const Eigen::Vector3d d = points.col(i).cast<double>() - end;
    if (d.squaredNorm() > most * most) continue;
    const double t = d.dot(away);
    if (t > slice && t <= length && (d - t * away).norm() <= wide + opening * t)
      ++held[static_cast<std::size_t>(t / slice)];
  }
  const auto isHeld = [&](std::size_t at) { return static_cast<double>(held[at]) > few; };
  std::size_t last = 1; // slice that holds points, with no two empty ones before it
  while (last + 2 < held.size() && (isHeld(last + 1) || isHeld(last + 2)))
    last += isHeld(last + 1) ? 1 : 2;
  return static_cast<double>(last) < allowed * static_cast<double>(held.size());
}

bool endsFree(const Pole& pole, const Eigen::Matrix3Xf& points, const PoleOptions& options) {
  const Eigen::Vector3d up = (pole.top - pole.foot).normalized();
  return endsFree(pole.top, up, pole, points, options) &&
         endsFree(pole.foot, -up, pole, points, options);
}

/// Adds the poles that are not among `poles` yet.
void addPoles(std::vector<Pole>& poles, const Eigen::Matrix3Xf& points, const PoleOptions& options,
              const Progress& progress) {
  constexpr double mostError = 0.35; // of the radius, or of the width where that is more
  const double edge = std::max<double>(options.mostRadius, 4 * options.width());
  const Voxels voxels(points, edge, progress.part(0, 0.3));
  std::vector<char> isFree(voxels.count(), 0);
  parallelFor(
      static_cast<Eigen::Index>(voxels.count()),
      [&](Eigen::Index i) {
        isFree[static_cast<std::size_t>(i)] =
            standsFree(voxels, static_cast<std::size_t>(i)) ? 1 : 0;
      },
      progress.part(0.3, 0.5), 256);
  for (std::size_t cube = 0; cube < voxels.count(); ++cube) {
    if (!isFree[cube]) continue;
    progress.update(0.5 + 0.5 * static_cast<double>(cube) / static_cast<double>(voxels.count()));
    const auto place =
        middleOf(columnFrom(cube, voxels, isFree), voxels, points, 0.4 * options.leastLength);
    if (!place || std::ranges::any_of(
                      poles, [&](const Pole& pole) { return isIn(pole, *place, options.width()); }))
      continue;
    std::optional<Pole> pole = poleAt(points, *place, options, progress.part(0.5, 0.5));
    if (!pole || (pole->top - pole->foot).norm() < options.leastLength) continue;
    const double width = std::max<double>(pole->radius, options.width());
    if (pole->error > mostError * width) continue; // a branch, not a wall
    if (isEven(*pole, points, options) && isBareWall(*pole, points, options) &&
        endsFree(*pole, points, options))
      poles.push_back(std::move(*pole));
  }
}

} // namespace

std::vector<Pole> polesIn(const Eigen::Matrix3Xf& points, const PoleOptions& options,
                          const Progress& progress) {
  std::vector<Pole> poles;
  if (points.cols() == 0) return poles;
  // What is thin and near to something else is found with less width than the noise has.
  PoleOptions narrower = options;
  for (double from = 0; from < 1; from = (1 + from) / 2) {
    const bool isLast = narrower.noise <= narrower.tolerance;
    addPoles(poles, points, narrower, progress.part(from, isLast ? 1 : (1 + from) / 2));
    if (isLast) break;
    narrower.noise = narrower.noise / 2;
  }
  std::ranges::stable_sort(poles, std::greater<>(),
                           [](const Pole& pole) { return pole.points.size(); });
  return poles;
}

} // namespace espalier
