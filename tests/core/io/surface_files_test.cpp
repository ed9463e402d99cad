#include "core/base/error.h"
#include "core/io/ply.h"
#include "core/io/surface_files.h"
#include "core/surface/generalized_cylinders.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

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
      OpenMesh::Vec3d place;
      in >> place[0] >> place[1] >> place[2];
      mesh.add_vertex(place);
    } else if (kind == "f") {
      int a = 0;
      int b = 0;
      int c = 0;
      in >> a >> b >> c;
      mesh.add_face(SurfaceMesh::VertexHandle(a - 1), SurfaceMesh::VertexHandle(b - 1),
                    SurfaceMesh::VertexHandle(c - 1));
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
  ASSERT_EQ(back.n_vertices(), surface.n_vertices());
  EXPECT_EQ(back.n_faces(), surface.n_faces());
  for (const auto vertex : surface.vertices())
    EXPECT_EQ(back.point(vertex), surface.point(vertex));
  EXPECT_EQ(volume(back), volume(surface));
}

TEST(SurfaceFiles, PlyGivesTheVerticesBackAndListsTheFaces) {
  const Skeleton plant = farFork();
  std::stringstream file;
  writePlySurface(file, plant);
  const SurfaceMesh surface = surfaceByGeneralizedCylinders(plant);
  const std::string bytes = file.str();
  const std::size_t header = bytes.find("end_header\n") + 11;
  EXPECT_EQ(bytes.size() - header, surface.n_vertices() * 24 + surface.n_faces() * 13);
  const RawPoints points = readPly(file, "surface.ply").value;
  ASSERT_EQ(points.positions.size(), surface.n_vertices());
  for (const auto vertex : surface.vertices()) {
    const OpenMesh::Vec3d& place = surface.point(vertex);
    EXPECT_EQ(points.positions[std::size_t(vertex.idx())],
              Eigen::Vector3d(place[0], place[1], place[2]));
  }
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
