#include "core/surface/surface_mesh.h"

namespace espalier {
namespace {

struct Corners {
  OpenMesh::Vec3d a, b, c;
};

Corners cornersOf(const SurfaceMesh& mesh, SurfaceMesh::FaceHandle face) {
  auto at = mesh.cfv_iter(face);
  const OpenMesh::Vec3d& a = mesh.point(*at++);
  const OpenMesh::Vec3d& b = mesh.point(*at++);
  return {a, b, mesh.point(*at)};
}

} // namespace

double volume(const SurfaceMesh& mesh) {
  if (mesh.n_vertices() == 0) return 0;
  // Tetrahedra to a vertex of the mesh: to a far origin they would cancel each other's digits.
  const OpenMesh::Vec3d origin = mesh.point(*mesh.vertices_begin());
  double sum = 0;
  for (const auto face : mesh.faces()) {
    const Corners corners = cornersOf(mesh, face);
    sum += (corners.a - origin).dot((corners.b - origin).cross(corners.c - origin));
  }
  return sum / 6;
}

double area(const SurfaceMesh& mesh) {
  double sum = 0;
  for (const auto face : mesh.faces()) {
    const Corners corners = cornersOf(mesh, face);
    sum += (corners.b - corners.a).cross(corners.c - corners.a).norm();
  }
  return sum / 2;
}

} // namespace espalier
