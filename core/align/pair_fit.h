#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <vector>

namespace espalier {

/// One target, seen in two scans.
struct TargetPair {
  Eigen::Vector3d moved; // [L], frame of the scan that is to be moved
  Eigen::Vector3d fixed; // [L], frame of the scan that stays
};

/// The motion that brings the moved scan to the fixed one by pairs of targets.
struct PairFit {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity();
  std::vector<double> residuals; // one per pair: from the moved target to the fixed one [L]
  double rms = 0;                // root mean square of these [L]
};

/// The rigid motion of the least squares of the distances between the targets of each pair.
///
/// @throws Error if there are under three pairs, a coordinate is not finite, the targets of one
///         scan lie at one place or on a line (within a hundredth of their spread), or those of one
///         scan are over twice as far apart as those of the other
/// Deterministic. Time O(pairs).
/// Source: S. Umeyama, "Least-squares estimation of transformation parameters between two point
/// patterns", PAMI 13(4), 1991, without its scale.
[[nodiscard]] PairFit fitPairs(const std::vector<TargetPair>& pairs);

/// How far the targets of each pair are apart under a motion [L].
[[nodiscard]] std::vector<double> distancesApart(const std::vector<TargetPair>& pairs,
                                                 const Eigen::Isometry3d& motion);

/// Root mean square of distances [L]; 0 of none.
[[nodiscard]] double rmsOf(const std::vector<double>& distances);

/// A fit by points took the targets clearly apart: over three times as far as pairs alone leave
/// them, and by more than the spacing of the points. All in [L].
[[nodiscard]] bool tookTargetsApart(double rms, double rmsByPairs, double spacing);

} // namespace espalier
