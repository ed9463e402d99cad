#include "tests/support/mesh_topology.h"

#include <Eigen/Geometry>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <gtest/gtest.h>

namespace espalier::test {
namespace {

using Mesh = OpenMesh::TriMesh_ArrayKernelT<>;

Mesh meshOf(int corners, const Triangles& triangles) {
  Mesh mesh;
  for (int i = 0; i < corners; ++i)
    mesh.add_vertex({});
  for (const auto& [a, b, c] : triangles) {
    const auto face =
        mesh.add_face(Mesh::VertexHandle(a), Mesh::VertexHandle(b), Mesh::VertexHandle(c));
    EXPECT_TRUE(face.is_valid()) << "the triangle " << a << ", " << b << ", " << c;
  }
  return mesh;
}

int pieces(const Mesh& mesh) {
  std::vector<bool> seen(mesh.n_vertices());
  int count = 0;
  for (const auto start : mesh.vertices()) {
    if (seen[std::size_t(start.idx())]) continue;
    ++count;
    std::vector<OpenMesh::SmartVertexHandle> open{start};
    while (!open.empty()) {
      const auto vertex = open.back();
      open.pop_back();
      if (seen[std::size_t(vertex.idx())]) continue;
      seen[std::size_t(vertex.idx())] = true;
      for (const auto near : vertex.vertices())
        open.push_back(near);
    }
  }
  return count;
}

int boundaryLoops(const Mesh& mesh) {
  std::vector<bool> seen(mesh.n_halfedges());
  int count = 0;
  for (const auto start : mesh.halfedges()) {
    if (!start.is_boundary() || seen[std::size_t(start.idx())]) continue;
    ++count;
    for (auto edge = start; !seen[std::size_t(edge.idx())]; edge = edge.next())
      seen[std::size_t(edge.idx())] = true;
  }
  return count;
}

} // namespace

MeshTopology topologyOf(int corners, const Triangles& triangles) {
  const Mesh mesh = meshOf(corners, triangles);
  return {.pieces = pieces(mesh),
          .boundaryLoops = boundaryLoops(mesh),
          .eulerCharacteristic =
              int(mesh.n_vertices()) - int(mesh.n_edges()) + int(mesh.n_faces())};
}

double volumeOf(const Eigen::Matrix3Xd& corners, const Triangles& triangles) {
  // Tetrahedra to a corner: to a far origin they would cancel each other's digits.
  const Eigen::Matrix3Xd places = corners.colwise() - corners.col(0).eval();
  double sum = 0;
  for (const auto& [a, b, c] : triangles)
    sum += places.col(a).dot(places.col(b).cross(places.col(c)));
  return sum / 6;
}

} // namespace espalier::test
