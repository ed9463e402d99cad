#pragma once

#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"
#include "core/io/points/read_options.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace espalier {

/// Whether a file that begins so is PCD.
[[nodiscard]] bool isPcd(std::string_view beginning);

/// Points of a PCD file, whose data may be ascii, binary or binary_compressed.
///
/// Fields may be of any type and count: x y z, intensity, and rgb or rgba, packed into the bits of
/// a float or an integer. Other fields are passed over. (Organized clouds mark missing points with
/// NaN.)
///
/// @param file     its name, for messages
/// @param options  which of them are kept
/// @throws Error naming the line of the header or of the text, or how many bytes are missing
/// Time O(size of the data), memory O(points that are kept); of compressed data O(size of the
/// data), as it cannot be unpacked in pieces.
/// Specification: "The PCD (Point Cloud Data) file format", version 0.7, Point Cloud Library.
[[nodiscard]] ImportedPoints readPcd(std::istream& in, const std::string& file,
                                     const ReadOptions& options = {},
                                     const Progress& progress = {});

} // namespace espalier
