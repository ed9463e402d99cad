#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace espalier {

/// A table with named columns.
struct CsvTable {
  struct Row {
    std::size_t line = 0;            // of the file, from 1
    std::vector<std::string> fields; // one per name
  };
  std::vector<std::string> names; // as the first line has them, trimmed
  std::vector<Row> rows;

  /// The place of a column, whatever the case of its letters; none if there is none.
  [[nodiscard]] std::optional<std::size_t> column(std::string_view name) const;
};

/// Reads a table of which the first line holds the names of the columns.
///
/// Fields are parted by commas, or by the semicolons or tabs that the first line has instead; those
/// in double quotes may hold anything, a quote written twice. Blanks around a plain field and lines
/// without any field do not count. An apostrophe that csvLine writes before a formula is taken off.
///
/// @param file  name for messages
/// @throws Error with the line if there are no names or over 1000, a name comes twice, a row is
///         longer than the first line, a quote is not closed, or the text is in UTF-16. Missing
///         fields at the end of a row are empty.
/// Time O(bytes). Source: RFC 4180.
[[nodiscard]] CsvTable readCsv(std::string_view text, const std::string& file);

/// One line of such a table, with commas and its end; what readCsv reads as `fields`. What a
/// spreadsheet would take for a formula, as "=1+1", gets an apostrophe before it, which the
/// spreadsheet does not show; numbers stay as they are.
[[nodiscard]] std::string csvLine(const std::vector<std::string>& fields);

} // namespace espalier
