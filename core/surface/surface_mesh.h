#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

namespace espalier {

struct SurfaceTraits : OpenMesh::DefaultTraitsDouble {};

/// Triangles, [L] in the frame of the skeleton; normals point out of the wood.
using SurfaceMesh = OpenMesh::TriMesh_ArrayKernelT<SurfaceTraits>;

/// Volume that a closed mesh holds [L^3]; parts that overlap count twice. O(faces).
[[nodiscard]] double volume(const SurfaceMesh& mesh);

/// Area of all triangles [L^2]. O(faces).
[[nodiscard]] double area(const SurfaceMesh& mesh);

} // namespace espalier
