#pragma once

#include "core/base/imported.h"
#include "core/mtg/mtg_of_skeleton.h"
#include "core/mtg/structure.h"

#include <string>
#include <vector>

namespace espalier {

/// The structure that an MTG describes. One without positions has no nodes; a note says so.
/// @param notes  that its reader had
/// @param file   its name, for messages
/// @throws Error if a value is no number, or as viewOf()
[[nodiscard]] Imported<Structure> structureOf(MtgFrame frame, std::vector<ShownMessage> notes,
                                              const std::string& file);

/// The text of a structure as an MTG. One that came from an MTG keeps it: edits go back into it,
/// and its text stays as it was where nothing was edited (see withEdits, mtgTextWith).
/// @param style  of a structure without scales of its own (hasScales)
/// @throws Error if it cannot be written as MTG text
[[nodiscard]] std::string mtgTextOf(const Structure& structure,
                                    MtgStyle style = MtgStyle::plantNode);

} // namespace espalier
