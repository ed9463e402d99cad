#pragma once

#include "core/skeleton/skeleton.h"

#include <iosfwd>

namespace espalier {

/// Writes a skeleton as Wavefront OBJ: a vertex `v` per node, an element `l` of two vertices per
/// edge, from the parent.
/// pre: positions are finite
/// Specification: Wavefront Technologies, "Object Files (.obj)", Advanced Visualizer manual.
void writeObjLines(std::ostream& out, const Skeleton& skeleton);

/// Writes a skeleton as PLY text: elements `vertex` (x y z radius, doubles) and `edge` (vertex1,
/// the parent, and vertex2; branching is 1 for +). pre: positions and radii are finite
/// Specification: G. Turk, "The PLY Polygon File Format", 1994.
void writePlyLines(std::ostream& out, const Skeleton& skeleton);

} // namespace espalier
