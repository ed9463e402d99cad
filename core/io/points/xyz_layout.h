#pragma once

#include "core/io/bytes/byte_source.h"
#include "core/io/points/point_field.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace espalier {

/// Why the columns of a text file may hold something else than what was found out.
enum class ColumnDoubt : std::uint8_t {
  none,
  notNumbers,  // a coordinate of the first point is none
  otherNames,  // a first line names as many columns, but not x, y and z
  twoPlaces,   // colors may be in columns 4 to 6 or 5 to 7
  withoutName, // there are more columns than could be named
};

/// How the points of a text file are laid out.
struct XyzLayout {
  char separator = ' '; // ' ' stands for any blanks and tabs
  bool hasDecimalComma = false;
  std::vector<PointField> columns;
  std::size_t needed = 3;     // columns up to the last that is wanted
  std::size_t headerLine = 0; // number of a line of names, 0 if there is none
  std::string names;          // that line, or the comment, that the columns were named by
  ColumnDoubt doubt = ColumnDoubt::none;
  std::optional<std::uint64_t> count; // of points, where the first line states it, as in PTS
};

/// Whether a line is empty or a comment: it begins with #, //, %, ! or ;.
[[nodiscard]] bool isComment(std::string_view line);

/// The next field of a line, without the blanks around it; `rest` loses it and its separator.
[[nodiscard]] std::string_view nextField(std::string_view& rest, char separator);

/// The number in `field`, whose decimal sign may be a comma.
[[nodiscard]] std::optional<double> numberInField(std::string_view field, bool hasDecimalComma);

/// Finds out the layout from the first 1000 lines, by the rules stated at `readXyz`; without
/// columns if there are no points.
/// @param file     its name, for messages; in .pts columns are in the order of Leica, intensity
///                 before color, unless something else is seen
/// @param columns  what the columns hold, as a user says; none: found out
/// @throws Error if `columns` are not those of the first line of points, or if it is no text
[[nodiscard]] XyzLayout xyzLayoutOf(ByteSource& source, const std::string& file,
                                    const std::vector<PointField>& columns = {});

} // namespace espalier
