#pragma once

#include "core/base/progress.h"
#include "core/cloud/organ.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace espalier {

/// Where a plant stands, and what each of its points lies on.
struct FoundOrgans {
  std::vector<Organ> ofPoint;
  Eigen::Index root = 0; // a point, of wood if there is some
};

/// Classifies the points of a plant by what is around them: its shape at five scales, what shortest
/// paths from the root lead on to, and then what the neighbors are found to be. The numbers are
/// fitted on simulated scans.
///
/// @param points   3 x N, finite [L], near ones together in their order, z up; N > 0
/// @param root     column of a point at the foot; none: the foot is looked for, and again among
///                 wood if it turns out to be none: what hangs lowest may be a leaf
/// @param spacing  of the points [L], > 0
/// @throws Cancelled if `progress` asks to stop
/// Deterministic for any number of threads. Time O(N log N).
/// Source: see core/clean/organ_features.h; logistic regressions as in core/decide/end_odds.h.
[[nodiscard]] FoundOrgans organsAmong(const Eigen::Matrix3Xf& points,
                                      std::optional<Eigen::Index> root, double spacing,
                                      const Progress& progress = {});

} // namespace espalier
