#pragma once

#include "core/base/progress.h"
#include "core/graph/neighborhoods.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// How a surface bends at a point. Positive where it bends away from its normal: on wood, whose
/// normals look outwards, the greater one is 1 / radius, and the lesser runs along the axis.
struct PrincipalCurvatures {
  double greatest = 0;                                         // [1/L]
  double least = 0;                                            // [1/L]
  Eigen::Vector3f greatestDirection = Eigen::Vector3f::Zero(); // unit, in the surface
  Eigen::Vector3f leastDirection = Eigen::Vector3f::Zero();
};

/// Curvatures of the quadric that fits a point's neighbors best: heights over the tangent plane as
/// a polynomial of second degree, by least squares.
///
/// Points with fewer than 6 neighbors, or with neighbors on a line, have no curvature: 0, and zero
/// directions.
/// @param normals 3 x N, unit: core/graph/normals.h
/// Deterministic; on all threads. @throws Cancelled if `progress` asks to stop
/// Time O(N k). Source: F. Cazals, M. Pouget, "Estimating differential quantities using polynomial
/// fitting of osculating jets", CAGD 22, 2005, degree 2.
[[nodiscard]] std::vector<PrincipalCurvatures>
principalCurvatures(const Eigen::Matrix3Xf& points, const Eigen::Matrix3Xf& normals,
                    const Neighborhoods& neighborhoods, const Progress& progress = {});

} // namespace espalier
