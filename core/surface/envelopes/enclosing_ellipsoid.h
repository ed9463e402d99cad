#pragma once

#include "core/surface/envelopes/envelope.h"

namespace espalier {

/// An ellipsoid by its three semi-axes [L] and where to they lie, a column of length 1 for each.
/// Parameters: the semi-axes; center; lean of the axis that is nearest to upright.
[[nodiscard]] Envelope ellipsoidOf(const Eigen::Vector3d& center, const Eigen::Vector3d& semiAxes,
                                   const Eigen::Matrix3d& directions);

/// The smallest ellipsoid about a crown, which may lean: its longest semi-axis is the first.
///
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Volume within 3e-4 of the least. Time O(steps corners) for the corners of the
/// convex hull.
/// Source: M. J. Todd, E. A. Yildirim, "On Khachiyan's algorithm for the computation of
/// minimum-volume enclosing ellipsoids", Discrete Applied Mathematics 155, 2007.
[[nodiscard]] Envelope ellipsoidEnvelope(const Crown& crown, const Progress& progress = {});

} // namespace espalier
