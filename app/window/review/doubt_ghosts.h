#pragma once

#include "core/doubt/doubt.h"
#include "core/skeleton/point_distances.h"
#include "ui/view/close_look.h"
#include "ui/view/ghost_overlay.h"

#include <vector>

namespace espalier {

/// The alternatives of a doubt, each with its number from 1 on, in that order. pre: isThere(doubt,
/// skeleton)
[[nodiscard]] std::vector<ShownGhost> ghostsOf(const Skeleton& skeleton, const Doubt& doubt);

/// The likeliest alternative of each doubt, without numbers. pre: they are there
[[nodiscard]] std::vector<ShownGhost> ghostsOfLikeliest(const Skeleton& skeleton,
                                                        const std::vector<Doubt>& doubts);

/// What is to be seen of a doubt: its wood, and its alternatives apart. Of wood that may grow
/// elsewhere, its foot. pre: isThere(doubt, skeleton)
[[nodiscard]] Sight sightOf(const Skeleton& skeleton, const Doubt& doubt);

/// What is to be shown with the question, however much is hidden: what is doubted, and some of the
/// wood that its alternatives name.
[[nodiscard]] std::vector<NodeId> woodSeenWith(const Skeleton& skeleton, const Doubt& doubt);

/// The points that a doubt is about, as dots: those nearest to its wood, and those that no wood is
/// near to along a branch that would be added.
/// @param near  [L] how far from the wood they are at most, > 0
/// pre: the distances are to `skeleton`. Time O(points): 1 ms for 150 000
[[nodiscard]] ShownGhost ghostOfPoints(const Skeleton& skeleton, const Doubt& doubt,
                                       const PointDistances& distances, double near);

} // namespace espalier
