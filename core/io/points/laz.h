#pragma once

#include "core/base/imported.h"
#include "core/base/progress.h"
#include "core/cloud/point_cloud.h"
#include "core/io/points/las_header.h" // isLaz

#include <iosfwd>
#include <string>

namespace espalier {

/// Points of a compressed LAS file (LAZ), COPC among them: the same as readLas of the file
/// unpacked.
///
/// Read are point formats 0 to 3 in versions 1 and 2 of their compression (of times and colors in
/// version 2), and 6 to 10 in versions 3 and 4. Chunks of points are decoded on all threads.
///
/// @param file  its name, for messages
/// @throws Error     if it is no LAZ file, is compressed in another form, or damaged
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time and memory O(N).
/// Format: M. Isenburg, "LASzip: lossless compression of LiDAR data", Photogrammetric Engineering &
/// Remote Sensing 79(2), 2013; of formats 6 to 10 the "Specification Document" in LASzip's
/// `design`.
[[nodiscard]] Imported<RawPoints> readLaz(std::istream& in, const std::string& file,
                                          const Progress& progress = {});

} // namespace espalier
