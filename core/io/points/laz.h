#pragma once

#include "core/base/progress.h"
#include "core/io/points/las_header.h" // isLaz
#include "core/io/points/read_options.h"

#include <iosfwd>
#include <string>

namespace espalier {

/// Points of a compressed LAS file (LAZ), COPC among them: the same as readLas of the file
/// unpacked.
///
/// Read are point formats 0 to 3 in versions 1 and 2 of their compression (of times and colors in
/// version 2), and 6 to 10 in versions 3 and 4. Chunks of points are decoded on all threads. Of a
/// part of a COPC file, only the chunks in which it lies are, level by level of the octree, and in
/// that order the points come.
///
/// @param file     its name, for messages
/// @param options  which of them are kept
/// @throws Error     if it is no LAZ file, is compressed in another form, or damaged
/// @throws Cancelled if `progress` asks to stop
/// Deterministic. Time O(N), of COPC O(points in the chunks read); memory O(points that are kept).
/// Format: M. Isenburg, "LASzip: lossless compression of LiDAR data", Photogrammetric Engineering &
/// Remote Sensing 79(2), 2013; of formats 6 to 10 the "Specification Document" in LASzip's
/// `design`.
[[nodiscard]] ImportedPoints readLaz(std::istream& in, const std::string& file,
                                     const ReadOptions& options = {},
                                     const Progress& progress = {});

} // namespace espalier
