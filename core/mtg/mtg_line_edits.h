#pragma once

#include "core/mtg/mtg.h"
#include "core/mtg/mtg_parser.h"

#include <optional>
#include <string>

namespace espalier {

/// The text of a file with an edited plant in it, where vertices came, went, or got other labels or
/// values: their lines alone change, and the comments of a line that goes stay in its place.
///
/// Vertices of both are matched in order, by what is said of them. A line that makes several
/// vertices stays or goes as a whole. A new vertex gets a line of its own behind the line of what
/// it is attached to, or behind all that is attached there before it.
///
/// pre: edited is as `mtgNormalized` gives, with the features of the file first, in their order
/// None if lines cannot hold it: a new class, a vertex that is attached within a line, no column
/// left.
/// The result is to be read and compared: what is attached elsewhere than before is not looked at.
/// Time O((size of both) times vertices that differ).
[[nodiscard]] std::optional<std::string> withOtherLines(const ParsedMtg& file, const Mtg& edited);

} // namespace espalier
