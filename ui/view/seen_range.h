#pragma once

#include "ui/view/camera.h"
#include "ui/view/scene.h"

#include <optional>

namespace espalier {

/// Between which values (heights, intensities) the points lie that one sees close up, but for the
/// least and the greatest hundredth: for colors that span these rather than those of all the plant.
///
/// None: points are not colored by such a value, or the usual range is not over half as wide again.
/// What is out of focus does not count. Of scans with more than 300 000 points it looks at so many.
/// Time O(points), some 5 ns each.
[[nodiscard]] std::optional<ValueRange> seenRange(const Scene& scene, const ScreenMap& screen);

} // namespace espalier
