#pragma once

#include "core/skeleton/skeleton.h"

#include <iosfwd>

namespace espalier {

/// Writes a skeleton as MTG text, in PlantScan3D's way: a plant P of scale 1 per root, its nodes N
/// of scale 2, features XX YY ZZ radius.
///
/// A branching node opens the next column, a successor continues its own ("^<N"); of two successors
/// the second opens a column too. Deeper than 64 columns, which no plant is, a node with nothing
/// but branching children continues its column with the last of them ("^+N"). Numbers are the
/// shortest decimals that read back as the same double, without exponents; a radius of 0 is left
/// empty. OpenAlea, PlantScan3D and MultiScaleTreeGraph.jl read the result.
/// @throws Error if a position or radius is not finite
void writeMtg(std::ostream& out, const Skeleton& skeleton);

} // namespace espalier
