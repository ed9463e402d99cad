#pragma once

#include "core/skeleton/frustum.h"

namespace espalier {

/// How much of the smaller of two frusta lies inside the other, seen in the plane through both that
/// start or end at one place: area in common / area of the smaller, in [0, 1]; 0 if one has none.
/// pre: a.from or a.to is b.from
[[nodiscard]] double flatOverlap(const Frustum& a, const Frustum& b);

} // namespace espalier
