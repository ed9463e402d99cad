#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"

#include <Eigen/Core>

#include <cstdint>

namespace espalier {

struct L1MedialOptions {
  double sampleShare = 0.2;         // of the points that become samples, (0, 1]
  Length firstRadius = spacings(4); // [L], > 0: of the neighborhoods in the first stage
  Length lastRadius = spacings(12); // [L], >= firstRadius: no stage looks farther
  int roundsPerStage = 20;          // at most, >= 1
  double repulsion = 0.35;          // of samples among each other, in [0, 0.5)
  double leastDirection = 0.9; // (0, 1]: samples that spread so much along a line become a branch
  std::uint64_t seed = 1;
};

/// Contracts a cloud to its L1-medial skeleton: samples move to the medians of the points about
/// them, while they push each other apart along the lines that they form.
///
/// Stage by stage neighborhoods grow by half of the first radius. At the end of each, samples that
/// lie on a line are traced: from the most directed one on to both sides, as long as they follow
/// each other without a sharp turn. Five in a row are a branch and stay from then on, so that thin
/// wood is done before the neighborhoods are as wide as thick wood. In the end each point moves
/// with the samples that were around it.
/// Bears holes and wood seen from one side. Slow; twigs closer than the radius may merge.
///
/// @param points 3 x N, finite [L]
/// @return 3 x N, the new place of each point [L]
/// @throws Cancelled if `progress` asks to stop
/// Deterministic: samples are drawn with the seed; on all threads. Time O(stages rounds S m) for S
/// samples with m points about each.
/// Source: H. Huang et al., "L1-medial skeleton of point cloud", ACM Trans. Graph. 32(4), 2013.
/// Differs: radii are given, as twice the diagonal over the cube root of N is wider than the gaps
/// between twigs; bridges between branches are not built, as a skeleton is made in a later step.
[[nodiscard]] Eigen::Matrix3Xf contractedToL1Medial(const Eigen::Matrix3Xf& points,
                                                    const L1MedialOptions& options,
                                                    const Progress& progress = {});

} // namespace espalier
