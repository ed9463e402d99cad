#pragma once

#include "core/skeleton/skeleton.h"
#include "core/surface/surface_mesh.h"

#include <iosfwd>

namespace espalier {

// The surface of a plant as triangles (see surfaceByGeneralizedCylinders), for programs that show
// or measure bodies. Each axis is a closed piece.

/// Writes OBJ text, v and f lines; numbers read back as the same doubles.
/// @throws Error if no node has a radius
/// Source of the format: Wavefront Technologies, "Object Files (.obj)", Advanced Visualizer manual.
void writeObjSurface(std::ostream& out, const Skeleton& skeleton);

/// Writes binary PLY, little-endian, vertices in double precision.
/// @throws Error if no node has a radius
/// Source of the format: G. Turk, "The PLY Polygon File Format", Stanford University, 1994.
void writePlySurface(std::ostream& out, const Skeleton& skeleton);

/// The same of any surface.
void writeObjSurface(std::ostream& out, const SurfaceMesh& mesh);
void writePlySurface(std::ostream& out, const SurfaceMesh& mesh);

} // namespace espalier
