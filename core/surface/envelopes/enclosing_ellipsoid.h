#pragma once

#include "core/surface/envelopes/envelope.h"

namespace espalier {

/// The smallest ellipsoid about a crown, which may lean.
///
/// Parameters: the semi-axes, longest first; center; lean of the axis that is nearest to upright.
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Volume within 3e-4 of the least. Time O(steps corners) for the corners of the
/// convex hull.
/// Source: M. J. Todd, E. A. Yildirim, "On Khachiyan's algorithm for the computation of
/// minimum-volume enclosing ellipsoids", Discrete Applied Mathematics 155, 2007.
[[nodiscard]] Envelope ellipsoidEnvelope(const Crown& crown, const Progress& progress = {});

} // namespace espalier
