#pragma once

#include "core/skeleton/skeleton.h"

#include <iosfwd>

namespace espalier {

/// Writes a node list with internode lengths and angles, as comma-separated text: comments that
/// define each column in words and by its formula, the names of the columns, a node per line.
/// Angles are in degrees; what a node has none of is empty. See `internodes` for their source.
/// pre: positions and radii are finite
void writeInternodeTable(std::ostream& out, const Skeleton& skeleton);

} // namespace espalier
