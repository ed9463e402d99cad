#pragma once

#include "core/base/progress.h"
#include "core/base/rule.h"
#include "core/decide/end_odds.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace espalier {

struct EndOptions {
  double leastProbability = 0.6;  // in [0, 1]: less probable ends go
  Length length = thicknesses(2); // [L] shorter ends go in any case
};

/// An end of which it was asked whether it is a shoot.
struct EndDecision {
  std::vector<Eigen::Vector3d> path; // [L] from its foot to its tip
  NodeId tip;                        // its id, if it stays
  EndEvidence evidence;
  double probability = 0; // that it is a shoot
  bool stays = true;
};

struct DecidedEnds {
  Skeleton skeleton;
  std::vector<EndDecision> decisions; // those that went, in the order in which they did, then those
                                      // that stay
};

/// How probable it is that an end is a shoot, in (0, 1).
using ShootProbability = std::function<double(const EndEvidence&)>;

/// A skeleton with those of its ends that are probably shoots.
///
/// The least probable go first, of each branching one; when one is gone, what it sat on may be
/// longer than it seemed, and stay. An unbranched plant stays as it is, and of each branching at
/// least one end.
///
/// @param points  that were scanned, 3 x N [L], in the frame of the skeleton after adding `origin`
/// @param scale   of the plant, spacing and height
/// Uses all threads, deterministic. Time O(N log n).
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] DecidedEnds
withDecidedEnds(const Skeleton& skeleton, const Eigen::Matrix3Xf& points,
                const Eigen::Vector3d& origin, const PlantScale& scale, const EndOptions& options,
                const Progress& progress = {},
                const ShootProbability& probability = probabilityAmongAll);

} // namespace espalier
