#pragma once

#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"
#include "core/io/points/read_options.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace espalier {

/// Whether a text that begins so is PTX: two lines of a number each, four of three, four of four.
[[nodiscard]] bool isPtx(std::string_view beginning);

/// Points of all blocks of a PTX file, each moved and turned by its matrix.
///
/// A block begins with the numbers of its columns and rows, the position and the three axes of the
/// scanner, and a matrix of 4 x 4, by which points are multiplied as rows from the left. Then come
/// columns times rows lines of x y z, with or without an intensity, with or without red green blue
/// (0 to 255, or fractions of 1). "0 0 0" is a direction without a return: it is left out, and
/// noted.
///
/// @param file     its name, for messages
/// @param options  which of them are kept
/// @throws Error naming the line that is wrong, or how many points are missing
/// Time O(size of the file), memory O(points that are kept).
/// Source: Leica Geosystems, as P. Bourke describes the format at paulbourke.net/dataformats/ptx.
[[nodiscard]] ImportedPoints readPtx(std::istream& in, const std::string& file,
                                     const ReadOptions& options = {},
                                     const Progress& progress = {});

} // namespace espalier
