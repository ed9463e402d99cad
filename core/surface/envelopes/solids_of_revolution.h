#pragma once

#include "core/surface/envelopes/envelope.h"

namespace espalier {

// Upright solids that are round about an axis, over `base`, the middle of their foot [L].
// Parameters: radius, or bottom_radius and top_radius; height; base.

[[nodiscard]] Envelope cylinderOf(double radius, double height, const Eigen::Vector3d& base);
[[nodiscard]] Envelope coneOf(double radius, double height, const Eigen::Vector3d& base);
[[nodiscard]] Envelope frustumOf(double bottomRadius, double topRadius, double height,
                                 const Eigen::Vector3d& base);
/// r^2 grows evenly from its top down.
[[nodiscard]] Envelope paraboloidOf(double radius, double height, const Eigen::Vector3d& base);

// The smallest of them about a crown. The cylinder's axis is
// that of the smallest circle about the crown from above; the others' is sought from there.
// @throws Cancelled if `progress` asks to stop
// Deterministic. Time O(evaluations corners log corners) for the corners of the convex hull.

[[nodiscard]] Envelope cylinderEnvelope(const Crown& crown, const Progress& progress = {});
[[nodiscard]] Envelope coneEnvelope(const Crown& crown, const Progress& progress = {});
[[nodiscard]] Envelope frustumEnvelope(const Crown& crown, const Progress& progress = {});
[[nodiscard]] Envelope paraboloidEnvelope(const Crown& crown, const Progress& progress = {});

} // namespace espalier
