// The table of formats in the manual says what the program reads and writes.
#include "core/io/formats.h"
#include "tests/support/manual.h"

#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// Of each row with extensions: "| .ply | yes | no |".
std::vector<std::string> rowsIn(const std::string& text) {
  std::vector<std::string> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream cells(line);
    std::string cell;
    std::vector<std::string> row;
    while (std::getline(cells, cell, '|'))
      row.push_back(cell);
    if (row.size() > 4 && row[2].starts_with(" ."))
      rows.push_back("|" + row[2] + "|" + row[3] + "|" + row[4] + "|");
  }
  return rows;
}

TEST(Manual, HasARowForEachFormat) {
  const std::vector<std::string> rows = rowsIn(test::manualText());
  std::size_t formatsInUse = 0;
  for (const Format& format : formats()) {
    if (!format.canRead() && !format.canWrite()) continue;
    ++formatsInUse;
    std::string row = "| ";
    for (const std::string_view extension : format.extensions)
      row += "." + std::string(extension) + " ";
    row += std::string("| ") + (format.canRead() ? "yes" : "no") + " | ";
    EXPECT_THAT(rows, Contains(row + (format.canWrite() ? "yes" : "no") + " |")) << format.name;
  }
  EXPECT_EQ(rows.size(), formatsInUse);
}

TEST(Manual, AdvisesAsTheProgramDoes) {
  EXPECT_THAT(test::manualText(),
              HasSubstr("`laszip -i a.laz -o a.las`")); // as unreadable LAZ files do
}

} // namespace
} // namespace espalier
