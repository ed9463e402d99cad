#pragma once

#include "core/mtg/mtg.h"
#include "core/mtg/mtg_reader.h"

#include <string>

namespace espalier {

/// The text of a file with an edited plant in it: as much as possible of it stays as it was.
///
/// Where `edited` has the vertices that reading the file gives, with the same labels, links,
/// aliases and number of dates in the same order, only the cells of values that differ are
/// replaced. Values are compared by feature name; numbers of type REAL and INT as numbers, so that
/// "1.50" stays for 1.5; NA, None and missing stay for none. Comments, blank lines, line ends,
/// spacing and columns stay. A line gets more tabs if it ends before its value, and its comment is
/// kept; a value of a range with << goes to its last vertex.
///
/// Features that `edited` does not have at all keep their cells.
/// Those that the file does not have get a line at the end of its section FEATURES and a column
/// behind the others, if it has both.
///
/// Where vertices came, went, or got other labels, their lines alone change (withOtherLines), if
/// lines can hold it.
///
/// Otherwise (vertices that are attached elsewhere, a new value within a range, a value that would
/// be read as a comment) the vertices are written anew, laid out as by `writeMtg`. All before them
/// stays, but for the line of columns where it has too few of them; if the sections cannot hold the
/// plant any more, or lack a feature, they are written anew too, and only what stands before CODE
/// stays. Line ends and the order of features stay. Comments of what is written anew go to the end,
/// as by `mtgCommentLines`.
///
/// The encoding is that of the file: Latin-1 unless a new value has a character beyond it, then
/// UTF-8.
/// @param original  the bytes of the file
/// @param options   as it was read
/// @throws Error as `readMtg` and `writeMtg`
/// Reading the result gives `edited`, but for the spelling of numbers and missing values, and as
/// `mtgAsWritten` where lines or vertices are written anew. Time O(size of both).
[[nodiscard]] std::string mtgTextWith(const std::string& original, const Mtg& edited,
                                      const MtgReadOptions& options = {});

} // namespace espalier
