#pragma once

#include "core/base/imported.h"
#include "core/mtg/mtg.h"

#include <iosfwd>
#include <string>
#include <string_view>

namespace espalier {

/// Whether a file that begins so is an MTG text.
[[nodiscard]] bool isMtg(std::string_view beginning);

/// Reads the text form of an MTG (FORM-A): sections CODE, CLASSES, DESCRIPTION, FEATURES and MTG,
/// where a line holds a code in one of the topological columns and values in those of the features.
///
/// Values are kept as written; those of type REAL and INT must be numbers, empty, NA, None or
/// missing. Columns need not be contiguous, nor features be declared: then their type is ALPHA.
/// A first part reached through a coarser vertex ("+A2/E1") hangs where the coarser one was reached
/// from, as in OpenAlea. See `MtgTopology` for the codes that are not read.
///
/// @param file  its name, for messages
/// @throws Error naming the line that is wrong
/// Time O(size of the file).
/// Source of the format: OpenAlea, "MTG file syntax"; PlantScan3D writes a part of it.
[[nodiscard]] Imported<Mtg> readMtg(std::istream& in, const std::string& file);

} // namespace espalier
