#pragma once

#include "core/io/points/xyz_layout.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace espalier {

/// A line of a text file of points, as its reader parts it.
struct TextLine {
  enum class Kind : std::uint8_t { comment, title, count, points };

  std::size_t number = 0; // from 1
  Kind kind = Kind::points;
  std::vector<std::string> fields; // of a comment or a count, the whole line is one
};

/// How a text file of points begins, and what its columns seem to hold.
struct FirstLines {
  std::vector<TextLine> lines;
  std::vector<PointField> columns; // found out
  ColumnDoubt doubt = ColumnDoubt::none;
  std::string names; // the line that names them; empty: none does
  bool hasDecimalComma = false;
};

/// The first `most` lines that are not empty, all of them read as the points are.
/// @throws Error as the reader of texts, if there are no points or fewer than 3 columns
[[nodiscard]] FirstLines firstLinesOf(ByteSource& source, const std::string& file,
                                      std::size_t most = 20);

/// Whether a line is a point if the columns hold this.
[[nodiscard]] bool isPoint(const TextLine& line, const std::vector<PointField>& columns,
                           bool hasDecimalComma);

} // namespace espalier
