#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace espalier {

// Which points are left out so that fewer are left. The points that stay are points of the scan.
// Deterministic for a seed, and but for rounding the same wherever the plant stands, however it is
// turned, and in whatever order its points are. @throws Cancelled if `progress` asks to stop

struct RandomThinningOptions {
  double share = 0.5; // of the points that stays, in (0, 1]
  int seed = 1;
};

/// Leaves out points by chance, so that exactly the share stays (rounded up). O(N log N).
[[nodiscard]] std::vector<bool> thinnedByChance(const Eigen::Matrix3Xf& points,
                                                const RandomThinningOptions& options,
                                                const Progress& progress = {});

struct VoxelThinningOptions {
  Length edge = spacings(2); // [L] of the cubes
};

/// Of each cube of an even grid the point stays that is nearest to the mean of those in it.
/// O(N log N).
[[nodiscard]] std::vector<bool> thinnedByVoxels(const Eigen::Matrix3Xf& points,
                                                const VoxelThinningOptions& options,
                                                const Progress& progress = {});

struct SpacingThinningOptions {
  Length spacing = spacings(2); // [L]
  int seed = 1;
};

/// No two points that stay are nearer to each other than the spacing, and each other point is that
/// near to one. O(N log N).
/// Source: Poisson disks by dart throwing: R. L. Cook, "Stochastic sampling in computer graphics",
/// ACM Trans. Graph. 5(1), 1986, with the points of the scan as darts.
[[nodiscard]] std::vector<bool> thinnedBySpacing(const Eigen::Matrix3Xf& points,
                                                 const SpacingThinningOptions& options,
                                                 const Progress& progress = {});

} // namespace espalier
