#include "core/base/error.h"
#include "core/io/points/first_lines.h"
#include "core/io/points/xyz.h"
#include "tests/core/io/samples.h"

#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

using enum PointField;
using testing::ElementsAre;
using testing::HasSubstr;

FirstLines firstLinesIn(const std::string& text, const std::string& file = "oak.xyz") {
  std::istringstream in(text);
  ByteSource source(in);
  return firstLinesOf(source, file);
}

std::string refusalOfLines(const std::string& text) {
  return test::errorOf([&] { return firstLinesIn(text); });
}

TEST(FirstLines, AreAsTheReaderPartsThem) {
  const FirstLines first = firstLinesIn("# oak\nx;y;z;i\n\n1;2,5;3;4\n5;6;7\n");
  ASSERT_EQ(first.lines.size(), 4U);
  EXPECT_EQ(first.lines[0].kind, TextLine::Kind::comment);
  EXPECT_THAT(first.lines[0].fields, ElementsAre("# oak"));
  EXPECT_EQ(first.lines[1].kind, TextLine::Kind::title);
  EXPECT_EQ(first.lines[2].kind, TextLine::Kind::points);
  EXPECT_EQ(first.lines[2].number, 4U) << "of the file";
  EXPECT_THAT(first.lines[2].fields, ElementsAre("1", "2,5", "3", "4"));
  EXPECT_THAT(first.columns, ElementsAre(x, y, z, intensity));
  EXPECT_EQ(first.names, "x;y;z;i");
  EXPECT_EQ(first.doubt, ColumnDoubt::none);
  EXPECT_TRUE(isPoint(first.lines[2], first.columns, first.hasDecimalComma));
  EXPECT_FALSE(isPoint(first.lines[3], first.columns, first.hasDecimalComma));
  EXPECT_TRUE(isPoint(first.lines[3], {x, y, z, none}, first.hasDecimalComma));
}

TEST(FirstLines, CountOfALeicaFileIsNoPoint) {
  const FirstLines first = firstLinesIn("2\n1 2 3 -5 9 9 9\n4 5 6 -7 8 8 8\n", "oak.pts");
  EXPECT_EQ(first.lines[0].kind, TextLine::Kind::count);
  EXPECT_THAT(first.columns, ElementsAre(x, y, z, intensity, red, green, blue));
  EXPECT_EQ(first.doubt, ColumnDoubt::none);
}

TEST(FirstLines, SayWhyColumnsAreInDoubt) {
  const auto doubt = [](const std::string& text) { return firstLinesIn(text).doubt; };
  EXPECT_EQ(doubt("1 2 3\n"), ColumnDoubt::none);
  EXPECT_EQ(doubt("1 2 3 0.5\n"), ColumnDoubt::none);
  EXPECT_EQ(doubt("1 2 3 10 20 30\n"), ColumnDoubt::none);
  EXPECT_EQ(doubt("x y z nx ny nz\n1 2 3 .1 .2 .3\n"), ColumnDoubt::none) << "they are named";
  EXPECT_EQ(doubt("Scan of an oak\n1 2 3\n"), ColumnDoubt::none) << "a title";
  EXPECT_EQ(doubt("1 2 3 .1 .2 .3\n"), ColumnDoubt::withoutName);
  EXPECT_EQ(doubt("1 2 3 10 20 30 40\n"), ColumnDoubt::twoPlaces);
  EXPECT_EQ(doubt("east north height\n1 2 3\n"), ColumnDoubt::otherNames);
  EXPECT_EQ(doubt("leaf 1 2 3\nleaf 4 5 6\n"), ColumnDoubt::notNumbers);
}

TEST(FirstLines, AreRefusedWhereThereAreNoPoints) {
  EXPECT_THAT(refusalOfLines("1 2\n3 4\n"), HasSubstr("has 2 columns, and a point has x, y and z"));
  EXPECT_THAT(refusalOfLines("# nothing\n"), HasSubstr("holds no points"));
  EXPECT_THAT(refusalOfLines("the oak is well and green\nas ever\n"), HasSubstr("holds no points"));
  EXPECT_THAT(refusalOfLines(std::string("1 2\0 3\n", 7)), HasSubstr("is no plain text"));
}

// The first line of such a file begins with a word, and is a point all the same.
TEST(FirstLines, AreReadAsPointsByColumnsThatAreNamed) {
  std::istringstream in("leaf 1 2 3\nleaf 4 5 6\n");
  const ImportedPoints read = readXyz(in, "oak.txt", {.columns = {none, x, y, z}});
  ASSERT_EQ(read.value.positions.size(), 2U);
  EXPECT_EQ(read.value.positions.front(), Eigen::Vector3d(1, 2, 3));
}

} // namespace
} // namespace espalier
