#pragma once

#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"
#include "core/io/points/read_options.h"

#include <iosfwd>
#include <string>

namespace espalier {

/// Points of a text file, one per line (XYZ, ASC, TXT, CSV, PTS).
///
/// The layout is found out so:
/// - Lines that are empty or begin with #, //, %, ! or ; are comments.
/// - Semicolons part the fields if there are any, else commas, else blanks and tabs. A comma is the
///   decimal sign where semicolons or blanks part the fields and no point stands in the line.
/// - A first line that begins with no number, or a comment before the data, names the columns if it
///   names x, y and z and has as many names as the data has columns. Case, quotes and units in
///   brackets do not matter.
/// - Else the columns are x y z; 4 or 5: intensity; from 6 on, color, where three columns hold
/// whole
///   numbers from 0 to 255: `r g b` from the 4th on (then a 7th and last is the intensity) or
///   `intensity r g b` from the 4th on; where both would do, a PTS file has the intensity first,
///   any other file the color. Columns left over are passed over, with a note.
/// - A line with nothing but a whole number, before the points or between them, is a count, as in
/// PTS.
///
/// @param file  its name, for messages; a PTS file is recognized by its extension
/// @param options  its columns, if there are any, are those of the file instead
/// @throws Error naming the line that is no point
/// Time O(size of the file), memory O(points that are kept).
[[nodiscard]] ImportedPoints readXyz(std::istream& in, const std::string& file,
                                     const ReadOptions& options = {},
                                     const Progress& progress = {});

/// Writes `x y z [intensity] [r g b]`, parted by blanks, points in the order of the file they came
/// from; more than x y z are named in a first line of comment ("//X Y Z ..."). Coordinates have the
/// fewest decimals that read back as the same position.
/// @param positions  3 x cloud.size() about cloud.origin() [L]: those of the cloud, or moved ones
/// @throws Cancelled if `progress` asks to stop
void writeXyz(std::ostream& out, const PointCloud& cloud, const Eigen::Matrix3Xf& positions,
              const Progress& progress = {});

} // namespace espalier
