#pragma once

#include "core/base/imported.h"
#include "core/mtg/mtg.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace espalier {

/// Whether a file that begins so is a pickle that mentions the class MTG of OpenAlea.
[[nodiscard]] bool isBmtg(std::string_view beginning);

/// Reads an MTG as PlantScan3D pickles it (.bmtg): an object of OpenAlea's class MTG, of which the
/// tables of scales, parents, complexes and properties are read. Nothing in the file is executed.
///
/// Property `position` becomes the features XX, YY and ZZ; other vectors three features NAME_x,
/// NAME_y and NAME_z; numbers, truth values and text a feature of type INT, REAL or ALPHA. A label
/// is a symbol and the index behind it; a vertex without one that can be written in an MTG gets P
/// on the coarsest scale, else N. What differs from an MTG text is put right, with a note on each:
/// - properties of vertices that were erased are left out;
/// - an edge of another type than < and +, as PlantScan3D's "N", or of none, is a successor if its
///   parent has no other, else branching;
/// - a symbol used on several scales is doubled on the finer ones, since a class has one scale;
/// - values of other kinds, as lists, or not finite, are left out.
/// Notes also report vertices with several successors and nodes at the place of their parent;
/// both are kept.
///
/// @param file  its name, for messages
/// @throws Error if the pickle asks for anything but plain data and the classes MTG and Vector3, if
///         its tables are not those of an MTG, or a vertex is among its own ancestors
/// Time O(N log N), memory O(N) for a file of N bytes.
/// Source: openalea.mtg, mtg.py and tree.py, and PlantScan3D's released files. No unit is stated.
[[nodiscard]] Imported<Mtg> readBmtg(std::istream& in, const std::string& file);

} // namespace espalier
