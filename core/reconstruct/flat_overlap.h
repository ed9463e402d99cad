#pragma once

#include <Eigen/Core>

namespace espalier {

/// A straight piece of wood that tapers.
struct Taper {
  Eigen::Vector3d from; // [L]
  Eigen::Vector3d to;
  double fromRadius; // [L], >= 0
  double toRadius;
};

/// How much of the smaller of two pieces lies inside the other, seen in the plane through both that
/// start or end at one place: area in common / area of the smaller, in [0, 1]; 0 if one has none.
/// pre: a.from or a.to is b.from
[[nodiscard]] double flatOverlap(const Taper& a, const Taper& b);

} // namespace espalier
