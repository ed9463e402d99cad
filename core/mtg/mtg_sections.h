#pragma once

#include "core/base/text.h"
#include "core/mtg/mtg.h"

#include <string>
#include <string_view>
#include <vector>

namespace espalier {

/// A comment before the sections: a code such as <N without ^ that stands below another of its
/// column hangs on the column before, whatever other programs take it for.
inline constexpr std::string_view previousColumnMark = "# dialect: previous column";

/// The fields of a line of an MTG file, parted by tabs, without blanks around them and without
/// comments: those last from # to the next tab.
[[nodiscard]] std::vector<std::string_view> mtgFields(std::string_view line);

/// Reads the sections before the vertices: CODE, CLASSES, DESCRIPTION, FEATURES. `lines` then stand
/// behind the line "MTG:".
/// @throws Error naming the line that is wrong
[[nodiscard]] Mtg readMtgSections(LineReader& lines, const std::string& file);

} // namespace espalier
