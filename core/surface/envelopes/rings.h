#pragma once

#include "core/surface/surface_mesh.h"

#include <Eigen/Core>

#include <vector>

namespace espalier {

/// How finely bodies that are round are made to triangles: of a circle 0.07 % are missing.
inline constexpr int ringCorners = 96;
inline constexpr int ringLevels = 48;

using Ring = std::vector<Eigen::Vector3d>; // counterclockwise as seen from above [L]

/// A closed surface over rings, from the lowest to the highest, with an end below and one above.
/// pre: rings are of one size, at least 3, and there is one
[[nodiscard]] SurfaceMesh meshOfRings(const Eigen::Vector3d& bottom, const std::vector<Ring>& rings,
                                      const Eigen::Vector3d& top);

/// What a profile turned about the upright line through `center` encloses.
/// @param profile radius and z, from the lowest to the highest [L]; ends on the axis are added
[[nodiscard]] SurfaceMesh meshOfTurned(const std::vector<Eigen::Vector2d>& profile,
                                       const Eigen::Vector2d& center);

} // namespace espalier
