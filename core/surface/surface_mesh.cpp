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

double volume(const SurfaceMesh& mesh) {
  if (mesh.corners.empty()) return 0;
  const Eigen::Vector3d about = mesh.corners.front(); // far origins cost digits
  const auto at = [&](int corner) {
    return Eigen::Vector3d(mesh.corners[static_cast<std::size_t>(corner)] - about);
  };
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    sum += at(a).cross(at(b)).dot(at(c));
  return sum / 6;
}

} // namespace espalier
