#include "core/clean/thinning.h"

#include "core/base/counted_random.h"
#include "core/base/paced_check.h"
#include "core/base/parallel.h"
#include "core/cloud/voxels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace espalier {
namespace {

/// Columns in an order that is drawn by chance. What is drawn for a point follows from how far it
/// is from the middle of all: so the same points come first however the plant stands, and in
/// whatever order they are.
std::vector<std::uint32_t> drawn(const Eigen::Matrix3Xf& points, int seed) {
  constexpr double step = 1e-5; // of the mean distance: rounding hardly leads to another
  const Eigen::Vector3d middle = points.cast<double>().rowwise().mean();
  const Eigen::VectorXd distances =
      (points.cast<double>().colwise() - middle).colwise().norm().transpose();
  const double width = std::max(step * distances.mean(), std::numeric_limits<double>::min());
  std::vector<double> draws(static_cast<std::size_t>(points.cols()));
  for (std::size_t i = 0; i < draws.size(); ++i) {
    const double steps = std::round(distances[static_cast<Eigen::Index>(i)] / width);
    draws[i] = CountedRandom(static_cast<std::uint64_t>(seed), static_cast<std::uint64_t>(steps))
                   .uniform();
  }
  std::vector<std::uint32_t> order(draws.size());
  std::iota(order.begin(), order.end(), 0U);
  parallelSort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return draws[a] != draws[b] ? draws[a] < draws[b] : a < b;
  });
  return order;
}

} // namespace

std::vector<bool> thinnedByChance(const Eigen::Matrix3Xf& points,
                                  const RandomThinningOptions& options, const Progress& progress) {
  const auto all = static_cast<std::size_t>(points.cols());
  std::vector<bool> isLeftOut(all, true);
  if (all == 0) return isLeftOut;
  progress.check();
  const std::vector<std::uint32_t> order = drawn(points, options.seed);
  const auto staying =
      std::min(all, static_cast<std::size_t>(std::ceil(options.share * static_cast<double>(all))));
  for (std::size_t i = 0; i < staying; ++i)
    isLeftOut[order[i]] = false;
  return isLeftOut;
}

std::vector<bool> thinnedByVoxels(const Eigen::Matrix3Xf& points,
                                  const VoxelThinningOptions& options, const Progress& progress) {
  std::vector<bool> isLeftOut(static_cast<std::size_t>(points.cols()), false);
  if (options.edge <= 0 || points.cols() == 0) return isLeftOut;
  isLeftOut.assign(isLeftOut.size(), true);
  const Voxels voxels(points, options.edge, progress.part(0, 0.7));
  const Eigen::Matrix3Xf means = voxels.means(points);
  for (std::size_t cube = 0; cube < voxels.count(); ++cube) {
    const Eigen::Vector3f mean = means.col(static_cast<Eigen::Index>(cube));
    const std::uint32_t nearest =
        *std::ranges::min_element(voxels.members(cube), {}, [&](std::uint32_t point) {
          return (points.col(point) - mean).squaredNorm();
        });
    isLeftOut[nearest] = false;
  }
  progress.update(1);
  return isLeftOut;
}

std::vector<bool> thinnedBySpacing(const Eigen::Matrix3Xf& points,
                                   const SpacingThinningOptions& options,
                                   const Progress& progress) {
  std::vector<bool> isLeftOut(static_cast<std::size_t>(points.cols()), false);
  if (options.spacing <= 0 || points.cols() == 0) return isLeftOut;
  isLeftOut.assign(isLeftOut.size(), true);
  const Voxels voxels(points, options.spacing, progress.part(0, 0.4));
  const std::vector<std::uint32_t> cubeOf = voxels.ofPoints();
  const auto nearest = static_cast<float>(options.spacing * options.spacing);
  const auto isNearOne = [&](std::uint32_t point, std::size_t cube) {
    return std::ranges::any_of(voxels.members(cube), [&](std::uint32_t other) {
      return !isLeftOut[other] && (points.col(point) - points.col(other)).squaredNorm() < nearest;
    });
  };
  PacedCheck check(progress);
  for (const std::uint32_t point : drawn(points, options.seed)) {
    check.after(5000);
    const Voxels::Place at = voxels.place(cubeOf[point]);
    bool isNear = isNearOne(point, cubeOf[point]);
    for (int i = 0; i < 27 && !isNear; ++i) {
      const auto cube = voxels.find(at + Voxels::Place(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1));
      isNear = cube && isNearOne(point, *cube);
    }
    if (!isNear) isLeftOut[point] = false;
  }
  progress.update(1);
  return isLeftOut;
}

} // namespace espalier
