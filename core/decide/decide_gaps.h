#pragma once

#include "core/decide/gap_odds.h"

#include <cstddef>
#include <vector>

namespace espalier {

/// A link that was asked about.
struct GapAlternative {
  Eigen::Vector3d from = Eigen::Vector3d::Zero(); // [L], a node of the wood that would bear
  Eigen::Vector3d to = Eigen::Vector3d::Zero();   // [L], one of the wood that would be borne
  double probability = 0;                         // that the wood grew so
};

/// By which of several links some wood beyond a gap is attached to the rest of the plant.
struct GapDecision {
  /// The most probable first; at most 4 and the chosen one. Links that are alike are one.
  std::vector<GapAlternative> alternatives;
  std::size_t chosen = 0; // the most probable, unless another link forbids that
  std::size_t nodes = 0;  // of the fragment that it attaches
};

struct DecidedGaps {
  Skeleton skeleton;
  std::vector<GapDecision> decisions; // one for each fragment but those with roots
};

/// `skeleton` with the gaps in it bridged by the links that are together the most probable, as
/// withJoinedGaps() does it by cost.
///
/// @param spacing  of points [L], > 0
/// @param up       length 1
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(n log n + ends * nodes in reach).
/// Source of the choice: core/graph/arborescence.h; of the odds: gap_odds.h.
[[nodiscard]] DecidedGaps withDecidedGaps(const Skeleton& skeleton, double spacing,
                                          const Eigen::Vector3d& up, const GapOptions& options,
                                          const Progress& progress = {},
                                          const GapOdds& odds = fittedGapOdds());

} // namespace espalier
