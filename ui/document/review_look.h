#pragma once

#include "core/cloud/point_cloud.h"
#include "core/skeleton/review_mark.h"

#include <QString>

namespace espalier {

/// "To do", "Doubtful", "Reviewed"
[[nodiscard]] QString titleOf(ReviewState state);

/// Grey, purple and blue: distinct from each other and from what is selected, to the color-blind
/// too, and at least 3:1 against the ground, dark or light.
[[nodiscard]] Color colorOf(ReviewState state, bool dark);

} // namespace espalier
