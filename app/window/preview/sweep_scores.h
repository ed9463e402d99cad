#pragma once

#include "app/window/preview/judged_state.h"
#include "ui/panels/sweep_card.h"

#include <vector>

namespace espalier {

/// What each card of a sweep says of its value, from the least value to the greatest.
///
/// The best is marked, unless half of the values share it. What is judged without a reference is
/// not marked at the ends: the more is contracted, the thinner it is, and the fewer points are left
/// unexplained by wood that is as thick, so the best of these is no choice.
/// @param haveEnds words and methods have none
[[nodiscard]] std::vector<std::vector<SweepScore>>
sweepScores(const std::vector<Judgment>& judgments, bool haveEnds = true);

} // namespace espalier
