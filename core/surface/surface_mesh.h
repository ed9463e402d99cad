#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace espalier {

/// Triangles, to be drawn, measured and written: nobody asks for their neighbors.
struct SurfaceMesh {
  std::vector<Eigen::Vector3d> corners;      // [L], frame of the skeleton
  std::vector<std::array<int, 3>> triangles; // corners, counterclockwise as seen from outside
};

/// Area of all triangles [L^2]. O(triangles).
[[nodiscard]] double area(const SurfaceMesh& mesh);

/// What a closed surface holds [L^3]; of pieces that overlap, each. O(triangles).
[[nodiscard]] double volume(const SurfaceMesh& mesh);

} // namespace espalier
