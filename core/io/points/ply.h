#pragma once

#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"
#include "core/io/points/read_options.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace espalier {

/// Whether a file that begins so is PLY.
[[nodiscard]] bool isPly(std::string_view beginning);

/// Points of a PLY file, ascii or binary of either byte order: its element `vertex`.
///
/// Properties may be of any scalar type: x y z; red green blue (also `diffuse_`; 8 bits, 16 bits or
/// fractions of 1); intensity, scalar_Intensity or reflectance; station, a number, with comments as
/// writePly() makes them that name it and say where the scanner stood. Other properties and
/// elements, lists too, are passed over; faces left out are noted.
///
/// @param file     its name, for messages
/// @param options  which of them are kept
/// @throws Error naming the line of the header or of the text, or how many bytes are missing
/// Time O(size of the file), memory O(points that are kept).
/// Specification: G. Turk, "The PLY Polygon File Format", 1994.
[[nodiscard]] ImportedPoints readPly(std::istream& in, const std::string& file,
                                     const ReadOptions& options = {},
                                     const Progress& progress = {});

/// Writes binary little endian: x y z as doubles, then what the cloud has of red green blue (uchar)
/// intensity (float) and station (ushort), which comments name (station_comment.h). Points are in
/// the order of the file they came from.
/// @param positions  3 x cloud.size() about cloud.origin() [L]: those of the cloud, or moved ones
/// @throws Cancelled if `progress` asks to stop
void writePly(std::ostream& out, const PointCloud& cloud, const Eigen::Matrix3Xf& positions,
              const Progress& progress = {});

} // namespace espalier
