#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace espalier {

struct FittedCircle {
  Eigen::Vector2d center; // [L]
  double radius;          // [L]
  double error;           // root mean square distance of the points to the circle [L]
  double coverage;        // share of 16 sectors around the center that hold points, [0, 1]
};

/// Taubin's circle through points of a plane; none for under 3 points or points on a line.
/// Nearly unbiased even on short arcs. Time O(n).
/// Source: G. Taubin, IEEE PAMI 13, 1991; solved by Newton's method after N. Chernov, "Circular and
/// linear regression", 2010.
[[nodiscard]] std::optional<FittedCircle> fitCircle(const std::vector<Eigen::Vector2d>& points);

/// A circle that is given, and how well `points` lie on it. pre: there are points
[[nodiscard]] FittedCircle judgedCircle(const Eigen::Vector2d& center, double radius,
                                        const std::vector<Eigen::Vector2d>& points);

} // namespace espalier
