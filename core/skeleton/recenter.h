#pragma once

#include "core/base/progress.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace espalier {

struct RecenterOptions {
  int rounds = 1; // >= 0
  double smoothing =
      0.2; // share of each move towards the mean of the neighbors on the axis, [0, 1]
  double leastCoverage = 0.6; // share of a circle that points must cover to trust it, (0, 1]
  double straightReach = 6; // in radii: between two trusted circles so near wood is straight, >= 0
};

/// `skeleton` with its nodes moved to the middle of the wood around them.
///
/// Each node looks at the points nearest to its edges, across the axis. Where they cover enough of
/// a circle, it moves to the center of the fitted circle, which a scan denser on one side does not
/// pull. Between two such nodes of an axis others move onto the line between them, as where
/// branches stand off; elsewhere, as on twigs thinner than the points are apart, they stay. Then
/// positions are smoothed along each axis. Nodes slide across their axis only, so nothing gets
/// shorter.
///
/// @param points 3 x N [L], in the frame of the skeleton after adding `origin`
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(rounds N log n). Source of the circle: G. Taubin, "Estimation of planar
/// curves, surfaces and nonplanar space curves", IEEE PAMI 13, 1991.
[[nodiscard]] Skeleton recentered(const Skeleton& skeleton, const Eigen::Matrix3Xf& points,
                                  const Eigen::Vector3d& origin,
                                  const RecenterOptions& options = {},
                                  const Progress& progress = {});

/// The middle of the wood around one node, from points near it [L]: the center of a circle fitted
/// to those at the halves of its edges along its axis; none if they do not cover enough of a
/// circle. pre: contains(id)
[[nodiscard]] std::optional<Eigen::Vector3d> sectionCenter(const Skeleton& skeleton, NodeId id,
                                                           const std::vector<Eigen::Vector3d>& near,
                                                           const RecenterOptions& options = {});

} // namespace espalier
