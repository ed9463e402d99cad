#pragma once

#include "core/surface/envelopes/envelope.h"
#include "core/surface/envelopes/outline.h"

namespace espalier {

/// An upright box between two heights. Parameters: length, width, height, center and the azimuth of
/// its length from x, in (-pi/2, pi/2].
[[nodiscard]] Envelope boxOf(const OutlineBox& box, double bottom, double top);

/// The smallest upright box about a crown. Deterministic. Time O(corners^2) of the outline.
[[nodiscard]] Envelope boxEnvelope(const Crown& crown);

} // namespace espalier
