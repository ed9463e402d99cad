#pragma once

#include "core/surface/envelopes/crown.h"

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace espalier {

/// The convex outline of a crown from above.
struct Outline {
  std::vector<Eigen::Vector2d> corners;             // counterclockwise [L]
  double area = 0;                                  // [L^2]
  Eigen::Vector2d middle = Eigen::Vector2d::Zero(); // its centroid [L]
  /// Of its longest principal axis, a unit vector: sides that are as long as wide have none, and
  /// get x.
  Eigen::Vector2d along = Eigen::Vector2d::UnitX();
};

[[nodiscard]] Outline outlineOf(const Crown& crown);

/// The smallest upright box about a crown lies along one side of its outline.
struct OutlineBox {
  Eigen::Vector2d along; // unit vector of the longer side
  Eigen::Vector2d middle;
  Eigen::Vector2d sides; // the longer first [L]
};
/// Source: H. Freeman, R. Shapira, "Determining the minimum-area encasing rectangle for an
/// arbitrary closed curve", Communications of the ACM 18, 1975.
[[nodiscard]] OutlineBox boxAround(const Outline& outline);

/// How far an outline reaches from a place inside of it, by azimuth. O(log corners) each.
class OutlineReach {
public:
  OutlineReach(const Outline& outline, const Eigen::Vector2d& from);
  [[nodiscard]] double at(double azimuth) const;            // [L]
  [[nodiscard]] std::vector<double> cornerAzimuths() const; // ascending, in (-pi, pi]

private:
  std::vector<std::pair<double, Eigen::Vector2d>> corners_; // about the place, by azimuth
};

} // namespace espalier
