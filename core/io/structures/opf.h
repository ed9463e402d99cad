#pragma once

#include "core/base/imported.h"
#include "core/mtg/mtg.h"
#include "core/skeleton/skeleton.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace espalier {

/// Whether a file that begins so is OPF, the Open Plant Format.
[[nodiscard]] bool isOpf(std::string_view beginning);

/// Reads the topology of an OPF file as an MTG.
///
/// The element `topology` is the scene if its scale is 0, else the first vertex. In a vertex,
/// `decomp` is a part of it, `follow` a successor, `branch` what branches off. A vertex of a
/// coarser scale that follows or branches off is attached to what the outer one is a part of, and
/// its own first part is attached to the outer one. All other elements are features, of the type
/// that attributeBDD states. Ids are numbers of the file and are not kept.
///
/// Where no vertex has features XX YY ZZ or X Y Z, positions are those that the matrices of
/// `geometry` give to the point (1, 0, 0): the upper end of a shape, which extends along x from 0
/// to 1. Meshes, materials and the tapers dUp and dDwn are left out.
///
/// @param file  its name, for messages
/// @throws Error naming the line that is wrong
/// Time O(size of the file).
/// Specification: OPF 2.0, AMAP (Archimed, Xplo), as PlantGeom.jl describes and reads it.
[[nodiscard]] Imported<Mtg> readOpf(std::istream& in, const std::string& file);

/// Writes OPF 2.0 without meshes: the entities of a skeleton as nested elements, with features XX
/// YY ZZ, radius and their own. A skeleton that is of no MTG has plants P of scale 1 and nodes N of
/// scale 2. Of the entities that start at a node, the coarsest is attached to the node before; the
/// finer ones are its parts. Names of features that XML does not allow get underscores.
/// pre: positions and radii are finite
void writeOpf(std::ostream& out, const Skeleton& skeleton);

/// The same of an MTG: all vertices, of all scales, with their features. A vertex is attached where
/// the text of an MTG attaches it (mtgRows). Indices, aliases and later dates have no place there.
/// @throws Error as mtgRows
void writeOpf(std::ostream& out, const Mtg& mtg);

} // namespace espalier
