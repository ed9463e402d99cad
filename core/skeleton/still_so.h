#pragma once

#include "core/skeleton/finding.h"
#include "core/skeleton/point_distances.h"

#include <vector>

namespace espalier {

/// What is known of the points of a scan now.
struct PointsNow {
  const Skeleton& skeleton;
  const PointDistances& distances; // to it
  double spacing;                  // [L], > 0
  double reach;                    // [L]: points farther from the wood are unexplained
};

/// Findings that were reported, are so no longer after an edit, and are mostly still so: at least
/// half of the points of a bare twig have no wood yet, and are no blade along an axis; of others,
/// the checks at twice the sensitivity find the same, with at least half of the amount.
///
/// @param reported  as they were reported first
/// @param now       what the checks find
/// @param weaker    what they find at twice the sensitivity
/// @param points    that the findings name; null: of points none is kept
/// Time O(reported (now + weaker)) and the points of `reported`.
[[nodiscard]] std::vector<Finding> stillSo(const std::vector<Finding>& reported,
                                           const std::vector<Finding>& now,
                                           const std::vector<Finding>& weaker,
                                           const PointsNow* points);

} // namespace espalier
