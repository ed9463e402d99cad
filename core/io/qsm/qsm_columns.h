#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace espalier {

/// What a column of a cylinder table holds; those of vectors are three in a row.
enum class QsmField : std::uint8_t {
  radius,
  length,
  startX,
  startY,
  startZ,
  axisX,
  axisY,
  axisZ,
  endX,
  endY,
  endZ,
  startRadius,
  parent,
  extension,
  branch,
  order
};

inline constexpr std::size_t qsmFieldCount = 16;

/// How the cylinders of a table are laid out.
struct QsmColumns {
  char separator = ',';
  std::array<std::optional<std::size_t>, qsmFieldCount> places; // of columns, by field
  std::size_t count = 0;                                        // of columns
  bool hasHeader = false;                                       // the first line names them
  std::vector<std::string> leftOut;                             // names of those without a field

  [[nodiscard]] const std::optional<std::size_t>& operator[](QsmField field) const {
    return places[static_cast<std::size_t>(field)];
  }
};

/// The columns of a table of cylinders, by the rules stated at `readQsmTable`; none if it is none.
[[nodiscard]] std::optional<QsmColumns> qsmColumnsIn(std::string_view beginning);

/// The fields of a line, without quotes and blanks around them.
[[nodiscard]] std::vector<std::string_view> qsmFields(std::string_view line, char separator);

} // namespace espalier
