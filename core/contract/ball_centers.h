#pragma once

#include "core/contract/circle_center.h"
#include "core/graph/geodesic_balls.h"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace espalier {

/// The circle whose center stands for a ball, if the arc of its points allows: see putCenters.
/// @param members of the ball, at least one
[[nodiscard]] std::optional<WoodCircle> circleOfBall(const std::vector<Eigen::Vector3f>& members,
                                                     double radius);

/// Puts the mean of each ball, or the center of a circle where `fitsCircles` and the arc of its
/// points allows, into the column of its center.
///
/// A circle needs to know how the wood runs: it is fitted where the points of a ball spread along a
/// line, across it, and is no larger than the ball.
/// @param radii  of the balls, by point [L]
void putCenters(const GeodesicBalls& balls, const Eigen::Matrix3Xf& points,
                const GeodesicBalls::Lanes& radii, bool fitsCircles, Eigen::Matrix3Xf& centers);

} // namespace espalier
