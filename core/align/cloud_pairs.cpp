#include "core/align/cloud_pairs.h"

#include "core/base/moments.h"
#include "core/base/parallel.h"
#include "core/cloud/voxels.h"

#include <algorithm>
#include <optional>

namespace espalier {
namespace {

using Eigen::Index;
using Eigen::Isometry3d;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr int neighbors = 12; // that show what the points about one sample

/// Which points of a cloud are one per cube: that nearest to the mean of the others.
std::vector<Index> onePerCube(const Eigen::Matrix3Xf& points, double edge,
                              const Progress& progress) {
  const Voxels voxels(points, edge, progress.part(0, 0.5));
  const Eigen::Matrix3Xf means = voxels.means(points, progress);
  std::vector<Index> chosen(voxels.count());
  parallelFor(
      static_cast<Index>(voxels.count()),
      [&](Index cube) {
        const auto off = [&](std::uint32_t point) {
          return (points.col(point) - means.col(cube)).squaredNorm();
        };
        const auto at = static_cast<std::size_t>(cube);
        chosen[at] = *std::ranges::min_element(voxels.members(at), {}, off);
      },
      progress.part(0.5, 1));
  parallelSort(chosen.begin(), chosen.end(), [&](Index a, Index b) {
    progress.check();
    return a < b;
  });
  return chosen;
}

SampledSurface surfaceOf(const Moments& moments, const Vector3d& place,
                         const std::optional<Vector3d>& scanner) {
  const auto solver = moments.components();
  const Vector3d spread = solver.eigenvalues().cwiseMax(0);
  SampledSurface surface;
  // A hundredth of the largest keeps what is perfectly flat or straight definite.
  const double least = spread[0] + 0.01 * spread[2] + std::numeric_limits<double>::min();
  const Vector3d weights =
      least / (spread.array() + 0.01 * spread[2] + std::numeric_limits<double>::min());
  surface.across = solver.eigenvectors() * weights.asDiagonal() * solver.eigenvectors().transpose();
  const bool isSurface = spread[0] < 0.25 * spread[1]; // a twig of few points faces nowhere
  if (scanner && isSurface) {
    surface.facing = solver.eigenvectors().col(0);
    if (surface.facing.dot(*scanner - place) < 0) surface.facing *= -1;
  }
  return surface;
}

/// How much a distance between two surfaces matters, by its direction. Where it is known how both
/// face, only along the middle of the two: that is 0 between any two places of one ball or stem.
Matrix3d acrossBoth(const Vector3d& facing, const SampledSurface& other) {
  const Vector3d middle = facing + other.facing;
  if (facing.isZero() || other.facing.isZero() || middle.isZero()) return other.across;
  const Vector3d normal = middle.normalized();
  return 0.99 * normal * normal.transpose() + 0.01 * Matrix3d::Identity();
}

} // namespace

SampledCloud sampled(const PointCloud& cloud, double edge, Index most, const Progress& progress) {
  const Eigen::Matrix3Xf& all = cloud.positions();
  const std::vector<Index> chosen = onePerCube(all, edge, progress.part(0, 0.5));
  SampledCloud scale{.points = all(Eigen::all, chosen), .surfaces = {}};
  const SpatialIndex index(scale.points, progress);
  std::vector<Index> wanted; // evenly, if there are too many
  const Index size = scale.points.cols();
  const Index count = std::min(size, most);
  for (Index i = 0; i < count; ++i)
    wanted.push_back(i * size / count);
  scale.surfaces.resize(wanted.size());
  parallelFor(
      count,
      [&](Index i) {
        const Index point = wanted[static_cast<std::size_t>(i)];
        const Eigen::Vector3f at = scale.points.col(point);
        const Index original = chosen[static_cast<std::size_t>(point)];
        // Two stations see two sides of a twig, which together are no surface.
        Moments moments(at.cast<double>());
        for (const Neighbor& other : index.nearest(at, 2 * neighbors)) {
          const Index its = chosen[static_cast<std::size_t>(other.index)];
          if (moments.count() < neighbors && cloud.stationOf(its) == cloud.stationOf(original))
            moments.add(Eigen::Vector3f(scale.points.col(other.index)));
        }
        std::optional<Vector3d> scanner;
        if (!cloud.stations().empty())
          scanner = cloud.stations()[cloud.stationOf(original)].scanner;
        if (scanner) *scanner -= cloud.origin();
        scale.surfaces[static_cast<std::size_t>(i)] =
            surfaceOf(moments, at.cast<double>(), scanner);
      },
      progress.part(0.5, 1));
  if (count < size) scale.points = Eigen::Matrix3Xf(scale.points(Eigen::all, wanted));
  return scale;
}

std::vector<CloudPair> CloudMatching::pairs(const Isometry3d& motion, double reach,
                                            double agreement, const Progress& progress) const {
  std::vector<CloudPair> all(moved_.surfaces.size());
  const auto pair = [&](Index i) {
    const auto k = static_cast<std::size_t>(i);
    const Vector3d place = motion * moved_.points.col(i).cast<double>();
    const SampledSurface& its = moved_.surfaces[k];
    const Vector3d facing = motion.linear() * its.facing;
    const auto sees = [&](Index other) {
      return facing.dot(fixed_.surfaces[static_cast<std::size_t>(other)].facing) >= agreement;
    };
    const auto found = index_.nearestIf(place.cast<float>(), static_cast<float>(reach), sees);
    if (!found) return;
    const Vector3d target = fixed_.points.col(found->index).cast<double>();
    const SampledSurface& other = fixed_.surfaces[static_cast<std::size_t>(found->index)];
    all[k] = {.place = place,
              .target = target,
              .across = acrossBoth(facing, other),
              .squared = (target - place).squaredNorm()};
  };
  parallelFor(static_cast<Index>(all.size()), pair, progress.part(0, 0), 64);
  return all;
}

} // namespace espalier
