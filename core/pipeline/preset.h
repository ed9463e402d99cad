#pragma once

#include "core/pipeline/pipeline.h"

#include <iosfwd>
#include <string>

namespace espalier {

/// Reads the methods and options of a preset, a JSON object of steps:
/// {"contract": {"method": "geodesic_centroid", "radius": 12.5}, ...}. Lengths are in [L], or
/// follow from the scan, as "7.5 spacings" and "0.01 heights"; choices are words, flags true or
/// false.
///
/// @throws Error if it is no such object, or names a step or method that does not exist
[[nodiscard]] PipelineOptions readPreset(std::istream& in);

/// The same of a file that a user wrote: options must exist, too, and messages name file and line.
/// @param file    name for messages
/// @param meters  in [L], for lengths as "38 mm"; 0: not known
[[nodiscard]] PipelineOptions readPreset(std::istream& in, const std::string& file,
                                         double meters = 0);

/// Writes what readPreset reads.
/// @param unit of the lengths, mm, cm or m: they are written with it, and hold for scans in another
///             one; empty: not known
void writePreset(std::ostream& out, const PipelineOptions& options, const std::string& unit = {});

} // namespace espalier
