#pragma once

#include "core/base/imported.h"
#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace espalier {

/// Whether a file that begins so is a binary scene of PlantGL.
[[nodiscard]] bool isBgeom(std::string_view beginning);

/// Points of a binary scene of PlantGL (.bgeom), as PlantScan3D keeps its scans: the point sets of
/// all its shapes, moved, scaled and turned as the scene says, groups and shared sets included.
///
/// Reals of 32 or 64 bits. A set without colors is white if another has some. What is no point set
/// is passed over with a note; so are points that the scene bends.
///
/// @param file  its name, for messages
/// @throws Error     naming the byte, if it is no such file, of a version after 2.5, cut short,
///                   nested deeper than 64 objects, holds an object of unknown size, or repeats
///                   shared points more than 16 times
/// @throws Cancelled if `progress` asks to stop
/// Time and memory O(N). No unit is stated.
/// Source: PlantGL's codec (scne_binaryparser, binaryprinter), versions 1.0 to 2.5; checked against
/// files of 2.3 and 2.4, which turn nothing.
[[nodiscard]] Imported<RawPoints> readBgeom(std::istream& in, const std::string& file,
                                            const Progress& progress = {});

} // namespace espalier
