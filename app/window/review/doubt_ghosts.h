#pragma once

#include "core/doubt/doubt.h"
#include "ui/view/close_look.h"
#include "ui/view/ghost_overlay.h"

#include <vector>

namespace espalier {

/// The alternatives of a doubt, each with its number from 1 on. pre: isThere(doubt, skeleton)
[[nodiscard]] std::vector<ShownGhost> ghostsOf(const Skeleton& skeleton, const Doubt& doubt);

/// The likeliest alternative of each doubt, without numbers. pre: they are there
[[nodiscard]] std::vector<ShownGhost> ghostsOfLikeliest(const Skeleton& skeleton,
                                                        const std::vector<Doubt>& doubts);

/// What is to be seen of a doubt: its wood, and its alternatives apart. Of wood that may grow
/// elsewhere, its foot. pre: isThere(doubt, skeleton)
[[nodiscard]] Sight sightOf(const Skeleton& skeleton, const Doubt& doubt);

} // namespace espalier
