#pragma once

#include "core/pipeline/method_probe.h"

namespace espalier {

// Parts of the probes of contractions.

using SeenBall = std::vector<std::uint32_t>; // SeenPoints by their place

/// Along the plant, where squared lengths along and across the wood have these weights.
[[nodiscard]] SeenBall ballAlongPlant(const SeenPoints& seen, const SeenFrom& from,
                                      double along = 1, double across = 1);
[[nodiscard]] SeenBall sectionOfWood(const SeenPoints& seen, const SeenFrom& from,
                                     double halfThickness);
[[nodiscard]] SeenBall withLinks(const SeenPoints& seen, std::uint32_t point);
[[nodiscard]] SeenBall nearestPoints(const SeenPoints& seen, std::uint32_t point, int count);

/// A method that looks within one radius [L] everywhere.
[[nodiscard]] MethodProbe probeWithin(double radius);
/// One that takes means of `count` nearest points.
[[nodiscard]] MethodProbe probeOfNearest(int count);

} // namespace espalier
