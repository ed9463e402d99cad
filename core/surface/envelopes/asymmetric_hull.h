#pragma once

#include "core/surface/envelopes/envelope.h"

#include <array>

namespace espalier {

/// A crown by six places and two exponents.
///
/// Its widest line goes through four places: along the axis that `azimuth` points to (0), across it
/// to the left (1), and behind and to the right (2, 3). Between two of them it is a quarter of an
/// ellipse as seen from above, x = r0 cos t, y = r1 sin t, at the height h0 cos^2 t + h1 sin^2 t.
/// From a place on it to the top go curves (r / R)^s + (z / H)^s = 1, where r and z are measured
/// from straight below the top at the height of that place: s = 1 makes a cone, 2 an ellipsoid,
/// less than 1 is hollow. Likewise down to the bottom.
struct AsymmetricHull {
  Eigen::Vector2d center = Eigen::Vector2d::Zero(); // [L], of the widest line
  double azimuth = 0;                               // [rad]
  std::array<double, 4> radii{};                    // [L]
  std::array<double, 4> heights{};                  // z of the four places [L]
  Eigen::Vector3d top = Eigen::Vector3d::Zero();    // [L]
  Eigen::Vector3d bottom = Eigen::Vector3d::Zero(); // [L]
  double topShape = 2;
  double bottomShape = 2;
};

/// What it holds [L^3], by formula: the integral of (1 - v^s)^(2/s) is a beta function.
/// pre: top and bottom stand within its widest line
[[nodiscard]] double volume(const AsymmetricHull& hull);
[[nodiscard]] SurfaceMesh meshOf(const AsymmetricHull& hull);

/// The asymmetric hull that lies nearest to the outer points of a crown.
///
/// Top and bottom are its highest and lowest points, or the middle of those at the same height. The
/// radii are fitted to the convex outline from above, heights and exponents to the outermost points
/// of cells by azimuth and height, by least squares of distances as shares of the radius. So part
/// of the points is outside: the share inside is a parameter.
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N + evaluations cells).
/// Source: R. Horn, 1971, and A. Cescatti, "Modelling the radiative transfer in discontinuous
/// canopies of asymmetric crowns", Ecological Modelling 101, 1997, as in F. Boudon, thesis, 2004,
/// 2.1.
[[nodiscard]] AsymmetricHull fitAsymmetricHull(const Crown& crown, const Progress& progress = {});

/// The same as an envelope, with its numbers and parameters.
[[nodiscard]] Envelope envelopeOf(const AsymmetricHull& hull);

[[nodiscard]] Envelope asymmetricEnvelope(const Crown& crown, const Progress& progress = {});

} // namespace espalier
