#include "core/base/text.h"
#include "core/io/formats.h"
#include "core/io/structures/internode_table.h"
#include "tests/support/plants.h"

#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

/// The cells of the rows below the names of columns.
std::vector<std::vector<std::string>> rowsOf(const Skeleton& skeleton) {
  std::ostringstream out;
  writeInternodeTable(out, skeleton);
  std::vector<std::vector<std::string>> rows;
  std::istringstream in(out.str());
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with('#')) continue;
    rows.emplace_back();
    std::istringstream cells(line + ",");
    for (std::string text; std::getline(cells, text, ',');)
      rows.back().push_back(text);
  }
  return rows;
}

// A trunk along z with a branch to x from its second node and one to y from its third.
TEST(InternodeTable, WritesLengthsAndAnglesInDegrees) {
  Skeleton plant = test::stick(4, 0.5);
  plant.add({.position = {2, 0, 0.5}, .parent = NodeId{1}, .edge = EdgeType::branching});
  plant.add({.position = {0, 2, 1}, .parent = NodeId{2}, .edge = EdgeType::branching});
  const auto rows = rowsOf(plant);
  ASSERT_EQ(rows.size(), 7U);
  for (const auto& row : rows)
    EXPECT_EQ(row.size(), rows[0].size());
  EXPECT_EQ(rows[1], (std::vector<std::string>{"1", "", "/", "0", "0", "0", "0.1", "", "", "", "",
                                               "", "", ""}));
  EXPECT_EQ(rows[2], (std::vector<std::string>{"2", "1", "<", "0", "0", "0.5", "0.1", "0.5", "0",
                                               "", "", "", "", ""}));
  const std::vector<std::string>& toY = rows[6]; // breadth first: it comes last
  const auto number = [&](std::size_t column) { return numberIn(toY[column]).value(); };
  EXPECT_EQ(toY[2], "+");
  EXPECT_DOUBLE_EQ(number(7), 2);     // length
  EXPECT_NEAR(number(8), 90, 1e-9);   // inclination
  EXPECT_NEAR(number(9), 90, 1e-9);   // turn
  EXPECT_NEAR(number(10), 90, 1e-9);  // absolute: y is a quarter turn from x
  EXPECT_NEAR(number(11), 90, 1e-9);  // counterclockwise from the branch to x
  EXPECT_NEAR(number(12), 270, 1e-9); // clockwise
  EXPECT_DOUBLE_EQ(number(13), 0.5);  // along the trunk
}

TEST(InternodeTable, DefinesEachOfItsColumns) {
  std::ostringstream out;
  writeInternodeTable(out, test::stick(2));
  const auto names = rowsOf(test::stick(2)).front();
  for (std::size_t i = 7; i < names.size(); ++i)
    EXPECT_THAT(out.str(), testing::HasSubstr("# " + names[i] + ": "));
}

TEST(InternodeTable, IsWrittenAsCsv) {
  EXPECT_EQ(formatToWrite("a.internodes.csv", Content::structure).name, "internodes");
  EXPECT_EQ(formatToWrite("a.csv", Content::points).name, "XYZ");
}

} // namespace
} // namespace espalier
