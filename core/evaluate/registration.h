#pragma once

#include "core/base/progress.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <optional>

namespace espalier {

struct RegistrationOptions {
  bool rotates = false;    // also turns, by some degrees; false: shifts only, for equal axes
  double searchRadius = 0; // [L], greatest shift looked for about either start; 0 = a tenth of the
                           // diagonal of the reference
  std::optional<Eigen::Isometry3d> motion; // known before: nothing is looked for
};

/// Where a result has to be moved to lie on its reference.
struct Registration {
  Eigen::Isometry3d motion = Eigen::Isometry3d::Identity(); // from the result's frame
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(); // of the middle of the result under motion [L]
  bool isGiven = false;                            // the motion was known before
  double reach = 0;          // [L], distances above it count as this: they are no pairs
  double residualBefore = 0; // [L], mean distance between the two both ways, each up to reach
  double residualAfter = 0;  // [L], the same after the motion; if found, not above residualBefore
};

/// Finds the rigid motion that lays a result on its reference.
///
/// Starts from the frames as they are, from the shift that most pairs of root, branchings and tips
/// agree on, and from the same about equal centroids; refines each by pairing even samples of
/// either skeleton with the nearest place of the other (iterated closest points, distances measured
/// across the edges, far pairs fading out), and keeps the best. What one of the two lacks or has
/// too much hardly pulls. Starting elsewhere must pay: the frames as they are win near ties.
///
/// @throws Error     if one of the two has no nodes, no length, or a position that is no number
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O((N + samples) log N) for at most 8 000 samples per refinement.
/// Source: P. Besl, N. McKay, "A method for registration of 3-D shapes", PAMI 14(2), 1992; with the
/// weights of S. Geman, D. McClure, 1987, and distances across edges after Y. Chen, G. Medioni,
/// 1992.
[[nodiscard]] Registration registration(const Skeleton& result, const Skeleton& reference,
                                        const RegistrationOptions& options = {},
                                        const Progress& progress = {});

[[nodiscard]] Skeleton moved(Skeleton skeleton, const Eigen::Isometry3d& motion);

} // namespace espalier
