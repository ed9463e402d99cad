#pragma once

#include "core/graph/geodesic_balls.h"

#include <Eigen/Core>

namespace espalier {

/// Puts the mean of each ball, or the center of a circle where `fitsCircles` and the arc of its
/// points allows, into the column of its center.
///
/// A circle needs to know how the wood runs: it is fitted where the points of a ball spread along a
/// line, across it, and is no larger than the ball.
/// @param radii  of the balls, by point [L]
void putCenters(const GeodesicBalls& balls, const Eigen::Matrix3Xf& points,
                const GeodesicBalls::Lanes& radii, bool fitsCircles, Eigen::Matrix3Xf& centers);

} // namespace espalier
