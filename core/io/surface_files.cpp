#include "core/io/surface_files.h"

#include "core/base/error.h"
#include "core/base/text.h"
#include "core/io/scalar.h"
#include "core/surface/generalized_cylinders.h"

#include <array>
#include <cstdint>
#include <ostream>

namespace espalier {
namespace {

SurfaceMesh surfaceOf(const Skeleton& skeleton) {
  SurfaceMesh mesh = surfaceByGeneralizedCylinders(skeleton);
  if (mesh.n_faces() == 0) throw Error("no axis has a length: there is no surface to write");
  return mesh;
}

std::array<std::int32_t, 3> cornersOf(const SurfaceMesh& mesh, SurfaceMesh::FaceHandle face) {
  std::array<std::int32_t, 3> corners{};
  auto next = corners.begin();
  for (const auto corner : mesh.fv_range(face))
    *next++ = corner.idx();
  return corners;
}

} // namespace

// OpenMesh's own writers round double coordinates to floats: half a meter in UTM coordinates.

void writeObjSurface(std::ostream& out, const Skeleton& skeleton) {
  const SurfaceMesh mesh = surfaceOf(skeleton);
  out << "# exported by Espalier\n";
  for (const auto vertex : mesh.vertices()) {
    const OpenMesh::Vec3d& place = mesh.point(vertex);
    out << "v " << plainDecimal(place[0]) << ' ' << plainDecimal(place[1]) << ' '
        << plainDecimal(place[2]) << '\n';
  }
  for (const auto face : mesh.faces()) {
    const auto [a, b, c] = cornersOf(mesh, face);
    out << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
  }
}

void writePlySurface(std::ostream& out, const Skeleton& skeleton) {
  const SurfaceMesh mesh = surfaceOf(skeleton);
  out << "ply\nformat binary_little_endian 1.0\ncomment exported by Espalier\nelement vertex "
      << mesh.n_vertices()
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
      << mesh.n_faces() << "\nproperty list uchar int vertex_indices\nend_header\n";
  std::string bytes;
  for (const auto vertex : mesh.vertices())
    for (int axis = 0; axis < 3; ++axis)
      appendValue(bytes, mesh.point(vertex)[axis]);
  for (const auto face : mesh.faces()) {
    appendValue(bytes, std::uint8_t{3});
    for (const std::int32_t corner : cornersOf(mesh, face))
      appendValue(bytes, corner);
  }
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

} // namespace espalier
