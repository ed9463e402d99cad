#pragma once

#include "core/surface/envelopes/envelope.h"

namespace espalier {

// The smallest upright solids about a crown that are round about an axis. The cylinder's axis is
// that of the smallest circle about the crown from above; the others' is sought from there.
// Parameters: radius, or bottom_radius and top_radius; height; base, the middle of its foot.
// @throws Cancelled if `progress` asks to stop
// Deterministic. Time O(evaluations corners log corners) for the corners of the convex hull.

[[nodiscard]] Envelope cylinderEnvelope(const Crown& crown, const Progress& progress = {});
[[nodiscard]] Envelope coneEnvelope(const Crown& crown, const Progress& progress = {});
[[nodiscard]] Envelope frustumEnvelope(const Crown& crown, const Progress& progress = {});
/// r^2 grows evenly from its top down.
[[nodiscard]] Envelope paraboloidEnvelope(const Crown& crown, const Progress& progress = {});

} // namespace espalier
