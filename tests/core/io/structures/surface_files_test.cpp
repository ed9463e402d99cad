#include "core/base/error.h"
#include "core/io/points/ply.h"
#include "core/io/structures/surface_files.h"
#include "core/surface/generalized_cylinders.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <string>

namespace espalier {
namespace {

Skeleton farFork() {
  Skeleton plant = test::fork(3);
  for (const NodeId id : plant.ids())
    plant.setPosition(id, plant[id].position + Eigen::Vector3d(654321.123, 5432109.876, 0));
  return plant;
}

/// Reads v and f lines.
SurfaceMesh readObj(std::istream& in) {
  SurfaceMesh mesh;
  std::string kind;
  while (in >> kind) {
    if (kind == "v") {
      Eigen::Vector3d& place = mesh.corners.emplace_back();
      in >> place.x() >> place.y() >> place.z();
    } else if (kind == "f") {
      std::array<int, 3>& triangle = mesh.triangles.emplace_back();
      for (int& corner : triangle) {
        in >> corner;
        --corner;
      }
    } else {
      std::getline(in, kind);
    }
  }
  return mesh;
}

TEST(SurfaceFiles, ObjGivesTheSurfaceBack) {
  const Skeleton plant = farFork();
  std::stringstream file;
  writeObjSurface(file, plant);
  const SurfaceMesh surface = surfaceByGeneralizedCylinders(plant);
  const SurfaceMesh back = readObj(file);
  EXPECT_EQ(back.corners, surface.corners);
  EXPECT_EQ(back.triangles, surface.triangles);
}

TEST(SurfaceFiles, PlyGivesTheVerticesBackAndListsTheFaces) {
  const Skeleton plant = farFork();
  std::stringstream file;
  writePlySurface(file, plant);
  const SurfaceMesh surface = surfaceByGeneralizedCylinders(plant);
  const std::string bytes = file.str();
  const std::size_t header = bytes.find("end_header\n") + 11;
  EXPECT_EQ(bytes.size() - header, surface.corners.size() * 24 + surface.triangles.size() * 13);
  EXPECT_EQ(readPly(file, "surface.ply").value.positions, surface.corners);
}

TEST(SurfaceFiles, ThereIsNoneOfAPlantWithoutRadiiOrLength) {
  std::ostringstream out;
  Skeleton plant = test::stick(2);
  for (const NodeId id : plant.ids())
    plant.setRadius(id, 0);
  EXPECT_THROW(writeObjSurface(out, plant), Error);
  EXPECT_THROW(writePlySurface(out, test::stick(1)), Error);
}

} // namespace
} // namespace espalier
