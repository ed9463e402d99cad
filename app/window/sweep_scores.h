#pragma once

#include "app/window/judged_state.h"
#include "ui/panels/sweep_card.h"

#include <vector>

namespace espalier {

/// What each card of a sweep tells of its value, by value. The best is marked, unless half of the
/// values share it.
[[nodiscard]] std::vector<std::vector<SweepScore>>
sweepScores(const std::vector<Judgment>& judgments);

} // namespace espalier
