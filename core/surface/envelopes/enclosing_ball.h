#pragma once

#include "core/surface/envelopes/envelope.h"

namespace espalier {

struct Ball3 {
  Eigen::Vector3d center = Eigen::Vector3d::Zero(); // [L]
  double radius = 0;                                // [L]
};

/// The smallest ball about some points; of points in a plane, the smallest circle is its great one.
/// @param points 3 x N [L], N > 0
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N), expected over their order, which is shuffled by a fixed seed.
/// Source: E. Welzl, "Smallest enclosing disks (balls and ellipsoids)", LNCS 555, 1991.
[[nodiscard]] Ball3 enclosingBall(const Eigen::Matrix3Xd& points, const Progress& progress = {});

[[nodiscard]] Envelope ballOf(const Ball3& ball);

/// The smallest ball about a crown.
[[nodiscard]] Envelope ballEnvelope(const Crown& crown, const Progress& progress = {});

} // namespace espalier
