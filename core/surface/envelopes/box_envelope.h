#pragma once

#include "core/surface/envelopes/envelope.h"

namespace espalier {

/// The smallest upright box about a crown. Parameters: length, width, height, center and the
/// azimuth of its length from x, in (-pi/2, pi/2]. Deterministic. Time O(corners^2) of the outline.
[[nodiscard]] Envelope boxEnvelope(const Crown& crown);

} // namespace espalier
