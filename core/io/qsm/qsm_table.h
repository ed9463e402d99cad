#pragma once

#include "core/base/imported.h"
#include "core/skeleton/skeleton.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace espalier {

/// Whether a file that begins so is a table of cylinders: its first line names a radius, a start, a
/// parent and a length or an end; or all its lines are 14, 15 or 17 numbers that can be TreeQSM's.
[[nodiscard]] bool isQsmTable(std::string_view beginning);

/// Reads a table of cylinders, parted by tabs, commas, semicolons or blanks, as a skeleton; see
/// `skeletonOf(const Qsm&, ...)` for how.
///
/// Columns are found by TreeQSM's names, whatever their case, units in parentheses and quotes:
/// radius, length, start (or start_point; start_x, start_y, start_z), axis (axis_direction; axis_x
/// ...), parent, extension, branch, BranchOrder (branch_order); and end_x, end_y, end_z,
/// start_radius as `writeQsmTable` adds. A name alone may stand for the three columns of start and
/// of axis, as TreeQSM 2.4 writes. Without names, columns are those of TreeQSM 2.0 to 2.3 (14 or
/// 15) or 2.4 (17). Other columns are left out, with a note.
///
/// @param file  its name, for messages
/// @throws Error naming the line that is no cylinder, and as `skeletonOf`
/// Time O(size of the file).
/// Source: TreeQSM 2.3 and 2.4, save_model_text.m; lengths are in m there.
[[nodiscard]] Imported<Skeleton> readQsmTable(std::istream& in, const std::string& file);

/// Writes the cylinders of `qsmOf` as CSV, in TreeQSM's columns: radius, length, start_x, start_y,
/// start_z, axis_x, axis_y, axis_z, parent, extension, branch, BranchOrder, PositionInBranch,
/// added, UnmodRadius; then end_x, end_y, end_z and start_radius, with which reading gives the same
/// skeleton. Lengths are in the unit of the skeleton. `added` is 0 and UnmodRadius the radius: this
/// program fits no cylinders.
/// @throws Error if a position or radius is not finite
void writeQsmTable(std::ostream& out, const Skeleton& skeleton);

} // namespace espalier
