#pragma once

#include "core/base/rule.h"
#include "core/base/spatial_index.h"

#include <Eigen/Core>

#include <optional>

namespace espalier {

/// What is fitted to the points near a place.
enum class LocalShape { plane, sphere };

/// The smooth surface that noisy points sample, by moving least squares: a place is on it if it is
/// on the plane, or algebraic sphere, that is fitted to the points near it, each with the weight
/// (1 - d^2 / r^2)^4 at distance d < r.
///
/// A plane lies inside curved wood, by the weighted mean of t^2 / 2R, where R is the radius of the
/// wood and t how far points are off across it: about r^2 / 24R. A sphere follows the bend, at 3
/// times the variance of a plane. Spheres are fitted without normals, by Pratt's norm. Source: M.
/// Alexa et al., "Point set surfaces", IEEE Visualization 2001, and "Computing and rendering point
/// set surfaces", IEEE TVCG 9(1), 2003, by the simpler projection of M. Alexa and A. Adamson, "On
/// normals and projection operators for surfaces defined by point sets", 2004; G. Guennebaud and M.
/// Gross, "Algebraic point set surfaces", SIGGRAPH 2007.
class LeastSquaresSurface {
public:
  /// @param points  3 x N; must outlive the surface, as must their index
  LeastSquaresSurface(const Eigen::Matrix3Xf& points, const SpatialIndex& index, LocalShape shape)
      : points_(points), index_(index), shape_(shape) {}

  /// Where a place comes to lie, moved along the normal of the surface: so the edge of a sheet does
  /// not recede.
  ///
  /// None where the points show no surface: fewer than 6 of them within `radius`, or such that
  /// spread through the surface by over 0.45 of what they do along it, as those of wood thinner
  /// than about the radius; and where the surface is farther away than `radius`.
  /// @param radius  of the ball of points that count [L], > 0
  /// Deterministic. Time O(points in the ball), a few times.
  [[nodiscard]] std::optional<Eigen::Vector3d> nearest(const Eigen::Vector3d& place,
                                                       double radius) const;

private:
  const Eigen::Matrix3Xf& points_;
  const SpatialIndex& index_;
  LocalShape shape_;
};

struct LeastSquaresOptions {
  Length radius = spacings(6); // of the balls that surfaces are fitted in [L], > 0
  int iterations = 1;          // >= 1; each takes the points where the one before left them
};

/// Moves each point to the surface that it and those near it sample; points that show no surface
/// stay where they are.
///
/// Of n points in a ball, evenly about its middle, scatter falls by the root of 2.8 / n for planes
/// and of 8.4 / n for spheres: to 0.16 and 0.27 of it for n = 113, of a grid 6 spacings around.
/// @param points  3 x N [L]
/// @return 3 x N
/// Deterministic; on all threads. Time O(N k) for k points in a ball; memory O(N).
/// @throws Cancelled if `progress` asks to stop
[[nodiscard]] Eigen::Matrix3Xf smoothedPoints(const Eigen::Matrix3Xf& points, LocalShape shape,
                                              const LeastSquaresOptions& options,
                                              const Progress& progress = {});

} // namespace espalier
