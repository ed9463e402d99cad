#pragma once

#include "core/io/points/point_collector.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace espalier {

/// How the points of a text file are laid out.
struct XyzLayout {
  char separator = ' '; // ' ' stands for any blanks and tabs
  bool hasDecimalComma = false;
  std::vector<PointField> columns;
  std::size_t needed = 3;             // columns up to the last that is wanted
  std::size_t headerLine = 0;         // number of a line of names, 0 if there is none
  std::optional<std::uint64_t> count; // of points, where the first line states it, as in PTS
};

/// Whether a line is empty or a comment: it begins with #, //, %, ! or ;.
[[nodiscard]] bool isComment(std::string_view line);

/// The next field of a line, without the blanks around it; `rest` loses it and its separator.
[[nodiscard]] std::string_view nextField(std::string_view& rest, char separator);

/// The number in `field`, whose decimal sign may be a comma.
[[nodiscard]] std::optional<double> numberInField(std::string_view field, bool hasDecimalComma);

/// Finds out the layout from the first 1000 lines, by the rules stated at `readXyz`.
/// @param isPts  whether columns are by default in the order of Leica: intensity before color
[[nodiscard]] XyzLayout xyzLayoutOf(std::string_view text, bool isPts);

} // namespace espalier
