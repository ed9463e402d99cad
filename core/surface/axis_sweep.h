#pragma once

#include "core/skeleton/axes.h"
#include "core/skeleton/skeleton.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// A circle that is swept along an axis.
struct Section {
  Eigen::Vector3d center;
  double radius;           // [L], > 0
  Eigen::Vector3d normal;  // unit, the direction in which the axis grows
  Eigen::Vector3d forward; // unit, in the plane of the circle: where its first corner lies
};

/// The circles through which the surface of an axis goes.
///
/// A smooth curve passes through the nodes (centripetal Catmull-Rom); radii change evenly along it.
/// An axis that branches begins at the node that bears it, in the direction of that one's axis, no
/// thicker than it, and so leaves it without a corner. An edge that turns gets more sections, so
/// that no two turn by more than `turn`. The circles do not twist about the axis
/// (rotation-minimizing frames).
///
/// @param radii  of all nodes by id, [L], > 0
/// @param turn   [rad], > 0
/// @return at least two sections; none if the axis has no length
/// Sources: E. Catmull, R. Rom, "A class of local interpolating splines", 1974, with the
/// parameters of C. Yuksel, S. Schaefer, J. Keyser, "Parameterization and applications of
/// Catmull-Rom curves", Computer-Aided Design 43, 2011; W. Wang, B. Juettler, D. Zheng, Y. Liu,
/// "Computation of rotation minimizing frames", ACM Trans. Graph. 27(1), 2008.
[[nodiscard]] std::vector<Section> sectionsOf(const Skeleton& skeleton, const Axis& axis,
                                              const std::vector<double>& radii, double turn);

} // namespace espalier
