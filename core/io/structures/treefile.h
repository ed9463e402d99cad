#pragma once

#include "core/base/imported.h"
#include "core/skeleton/skeleton.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace espalier {

/// Whether a file that begins so is a treefile: its first line that is no comment begins with
/// "x,y,z,radius" and names parent_id.
[[nodiscard]] bool isTreefile(std::string_view beginning);

/// Skeleton of a treefile of RayCloudTools (its "_trees.txt").
///
/// Comments begin with #. A line names the fields of a segment, "x,y,z,radius,parent_id" and more;
/// a second such list after a blank is for all segments but the first of each tree. Then each line
/// is a tree, its segments parted by commas as their fields are. A segment ends at x y z, has this
/// radius, and begins where the segment parent_id of the same line ends, counted from 0; the first,
/// with the parent -1, is the foot. Without parent_id a tree is its foot alone.
///
/// A segment becomes the node at its end. Treefiles have no edge types: the child that carries most
/// continues an axis, as `withAssembledAxes` chooses. Other fields are left out, with a note.
///
/// @param file  its name, for messages
/// @throws Error naming the line, and the segment in it, that is wrong
/// Time O(size of the file).
/// Specification: RayCloudTools (CSIRO), raylib/rayforeststructure.cpp, 2022.
[[nodiscard]] Imported<Skeleton> readTreefile(std::istream& in, const std::string& file);

/// Writes fields x y z radius parent_id, a line per tree, each segment after its parent.
/// pre: positions and radii are finite
void writeTreefile(std::ostream& out, const Skeleton& skeleton);

} // namespace espalier
