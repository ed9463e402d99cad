#include "core/surface/surface_mesh.h"

#include <Eigen/Geometry>

namespace espalier {

double area(const SurfaceMesh& mesh) {
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Eigen::Vector3d& from = mesh.corners[static_cast<std::size_t>(a)];
    const Eigen::Vector3d normal = (mesh.corners[static_cast<std::size_t>(b)] - from)
                                       .cross(mesh.corners[static_cast<std::size_t>(c)] - from);
    sum += normal.norm();
  }
  return sum / 2;
}

} // namespace espalier
