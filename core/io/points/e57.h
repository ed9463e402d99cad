#pragma once

#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"
#include "core/io/points/read_options.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace espalier {

/// Whether a file that begins so is E57.
[[nodiscard]] bool isE57(std::string_view beginning);

/// Points of all scans of an E57 file, each moved and turned by its pose.
///
/// Positions may be Cartesian or spherical, fields Float, Integer or ScaledInteger; colors are
/// scaled from their limits to 0 to 255, intensities stay as they are. Points whose position is
/// marked as invalid are left out, with a note. Other fields, images and extensions are passed
/// over, and the checksums of their pages are not checked.
///
/// @param file     its name, for messages
/// @param options  which of them are kept
/// @throws Error naming the byte that is wrong, for a damaged page its number, or the line of the
///               XML section
/// Time O(size of the file), memory O(points that are kept).
/// Specification: ASTM E2807-11, "Standard Specification for 3D Imaging Data Exchange,
/// Version 1.0".
[[nodiscard]] ImportedPoints readE57(std::istream& in, const std::string& file,
                                     const ReadOptions& options = {},
                                     const Progress& progress = {});

} // namespace espalier
