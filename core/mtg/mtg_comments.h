#pragma once

#include "core/mtg/mtg_parser.h"

#include <cstddef>
#include <string>

namespace espalier {

/// The comments of a file between two bytes of its text, to stand in another text of the same
/// plant: a line each, with \n, that names the vertex of its line or of the next line, as "# at
/// N12: dead"; without it above the vertices, and behind the last, so that doing it again changes
/// nothing. The signs of comments around them are left out. Time O(size).
[[nodiscard]] std::string mtgCommentLines(const ParsedMtg& file, std::size_t from,
                                          std::size_t to = std::string::npos);

} // namespace espalier
