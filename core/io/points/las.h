#pragma once

#include "core/base/progress.h"
#include "core/io/points/las_header.h" // isLas
#include "core/io/points/read_options.h"

#include <iosfwd>
#include <string>

namespace espalier {

/// Points of a LAS file of version 1.0 to 1.4, point formats 0 to 10.
///
/// Coordinates are scaled and offset in double precision. Colors of 16 bits become bytes;
/// intensities and colors that are all 0 count as none. Points flagged as withheld are left out,
/// with a note. Waveforms, times, returns and classes are passed over.
///
/// @param file     its name, for messages
/// @param options  which of them are kept
/// @throws Error     if it is no LAS file, is compressed (see readLaz), of a later version, or cut
///                   short
/// @throws Cancelled if `progress` asks to stop
/// Time O(N), memory O(points that are kept).
/// Specification: ASPRS, "LAS Specification 1.4 - R15", 2019, and those of 1.0 to 1.3.
[[nodiscard]] ImportedPoints readLas(std::istream& in, const std::string& file,
                                     const ReadOptions& options = {},
                                     const Progress& progress = {});

} // namespace espalier
