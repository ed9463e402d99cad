#pragma once

#include "core/base/text.h"
#include "core/mtg/mtg.h"
#include "core/mtg/mtg_notes.h"

#include <string>
#include <string_view>
#include <vector>

namespace espalier {

/// A comment before the sections: a code such as <N without ^ that stands below another of its
/// column is attached to the column before, whatever other programs take it for.
inline constexpr std::string_view previousColumnMark = "# dialect: previous column";

/// The fields of a line of an MTG file, parted by tabs, without blanks around them.
/// pre: comments are taken out of it
[[nodiscard]] std::vector<std::string_view> mtgFields(std::string_view line);

/// The section that a line opens, if it does: "FEATURES :", or its name alone; else empty.
[[nodiscard]] std::string_view mtgSectionOf(std::string_view line);

/// Whether a line that begins with this field is that of the columns: ENTITY-CODE, or TOPO.
[[nodiscard]] bool isMtgColumnName(std::string_view field);

/// Before the line "CODE : FORM-A": a title may stand above it. None if there is no such line.
/// pre: comments are taken out of the text
[[nodiscard]] std::optional<LineReader> mtgCodeIn(std::string_view text);

/// The line end of a text: that of its first line.
[[nodiscard]] std::string lineEndOf(const std::string& text);

/// Reads the sections before the vertices: CODE, CLASSES, DESCRIPTION, FEATURES. `lines` then stand
/// behind the line "MTG:". A feature without a type becomes ALPHA, one listed twice is taken once.
/// Names of sections, headings and types are read in capital and in small letters; a type may be
/// followed by a remark.
/// @throws Error naming the line that is wrong
[[nodiscard]] Mtg readMtgSections(LineReader& lines, MtgNotes& notes);

} // namespace espalier
