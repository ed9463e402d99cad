#include "core/io/structures/surface_files.h"

#include "core/base/shown_message.h"
#include "core/base/text.h"
#include "core/io/bytes/scalar.h"
#include "core/surface/generalized_cylinders.h"

#include <cstdint>
#include <ostream>

namespace espalier {
namespace {

SurfaceMesh surfaceOf(const Skeleton& skeleton) {
  SurfaceMesh mesh = surfaceByGeneralizedCylinders(skeleton);
  if (mesh.triangles.empty())
    throw ShownError({espalier::Shown::tr("no axis has a length: there is no surface to write")});
  return mesh;
}

} // namespace

void writeObjSurface(std::ostream& out, const Skeleton& skeleton) {
  writeObjSurface(out, surfaceOf(skeleton));
}

void writePlySurface(std::ostream& out, const Skeleton& skeleton) {
  writePlySurface(out, surfaceOf(skeleton));
}

void writeObjSurface(std::ostream& out, const SurfaceMesh& mesh) {
  out << "# exported by Espalier\n";
  for (const Eigen::Vector3d& place : mesh.corners)
    out << "v " << plainDecimal(place.x()) << ' ' << plainDecimal(place.y()) << ' '
        << plainDecimal(place.z()) << '\n';
  for (const auto& [a, b, c] : mesh.triangles)
    out << "f " << a + 1 << ' ' << b + 1 << ' ' << c + 1 << '\n';
}

void writePlySurface(std::ostream& out, const SurfaceMesh& mesh) {
  out << "ply\nformat binary_little_endian 1.0\ncomment exported by Espalier\nelement vertex "
      << mesh.corners.size()
      << "\nproperty double x\nproperty double y\nproperty double z\nelement face "
      << mesh.triangles.size() << "\nproperty list uchar int vertex_indices\nend_header\n";
  std::string bytes;
  for (const Eigen::Vector3d& place : mesh.corners)
    for (const double coordinate : place)
      appendValue(bytes, coordinate);
  for (const auto& triangle : mesh.triangles) {
    appendValue(bytes, std::uint8_t{3});
    for (const std::int32_t corner : triangle)
      appendValue(bytes, corner);
  }
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

} // namespace espalier
