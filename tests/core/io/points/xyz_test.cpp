#include "core/base/random.h"
#include "core/base/shown_message.h"
#include "core/io/points/xyz.h"
#include "tests/core/io/samples.h"

#include <cmath>
#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Imported<RawPoints> importXyz(const std::string& text, const std::string& file = "oak.xyz") {
  std::istringstream in(text);
  return readXyz(in, file);
}

std::string refusalOfXyz(const std::string& text) {
  return test::errorOf([&] { return importXyz(text); });
}

struct Spelling {
  const char* name;
  const char* text;
};

void PrintTo(const Spelling& spelling, std::ostream* out) {
  *out << spelling.name;
}

class ReadXyzSpelled : public testing::TestWithParam<Spelling> {};

TEST_P(ReadXyzSpelled, FindsTheSamePoints) {
  const RawPoints points = importXyz(GetParam().text).value;
  EXPECT_THAT(points.positions,
              ElementsAre(Eigen::Vector3d(1.5, -2, 3), Eigen::Vector3d(4, 5, 6.25)));
  EXPECT_THAT(points.colors, IsEmpty());
  EXPECT_THAT(points.intensities, IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(
    All, ReadXyzSpelled,
    testing::Values(Spelling{"blanks", "1.5 -2 3\n4 5 6.25\n"},
                    Spelling{"tabs and more blanks", "  1.5\t-2  3 \r\n\r\n4\t5\t6.25"},
                    Spelling{"commas", "1.5,-2,3\n4,5,6.25\n"},
                    Spelling{"commas and blanks", "1.5, -2, 3\n4, 5, 6.25\n"},
                    Spelling{"semicolons", "1.5;-2;3\n4;5;6.25\n"},
                    Spelling{"semicolons and decimal commas", "1,5;-2;3\n4;5;6,25\n"},
                    Spelling{"blanks and decimal commas", "1,5 -2,0 3,0\n4,0 5,0 6,25\n"},
                    Spelling{"a decimal comma that comes late", "1,5 -2 3\n4 5 6,25\n"},
                    Spelling{"exponents", "15e-1 -2E0 +3\n4 5 625e-2\n"},
                    Spelling{"comments", "# a\n// b\n! c\n% d\n1.5 -2 3\n# e\n4 5 6.25\n"},
                    Spelling{"a title", "Pine of plot 3\n1.5 -2 3\n4 5 6.25\n"},
                    Spelling{"names", "x,y,z\n1.5,-2,3\n4,5,6.25\n"},
                    Spelling{"names with units",
                             "\"X [m]\";\"Y [m]\";\"Z [m]\"\n1.5;-2;3\n4;5;6.25\n"},
                    Spelling{"names in another order", "z y x\n3 -2 1.5\n6.25 5 4\n"},
                    Spelling{"a count", "2\n1.5 -2 3\n4 5 6.25\n"},
                    Spelling{"two scans", "1\n1.5 -2 3\n1\n4 5 6.25\n"},
                    Spelling{"a byte order mark", "\xEF\xBB\xBF"
                                                  "1.5 -2 3\n4 5 6.25\n"}));

TEST(ReadXyz, RecognizesColumnsByWhatTheyHold) {
  const RawPoints intensity = importXyz("1 2 3 0.5\n4 5 6 0.75\n").value;
  EXPECT_THAT(intensity.intensities, ElementsAre(0.5F, 0.75F));

  const RawPoints color = importXyz("1 2 3 10 20 30\n4 5 6 255 0 1\n").value;
  EXPECT_THAT(color.colors, ElementsAre(Color{10, 20, 30}, Color{255, 0, 1}));
  EXPECT_THAT(color.intensities, IsEmpty());

  const RawPoints leica = importXyz("1 2 3 -700 10 20 30\n4 5 6 -800 40 50 60\n").value;
  EXPECT_THAT(leica.intensities, ElementsAre(-700.0F, -800.0F));
  EXPECT_THAT(leica.colors, ElementsAre(Color{10, 20, 30}, Color{40, 50, 60}));

  const RawPoints colorFirst = importXyz("1 2 3 10 20 30 0.5\n4 5 6 40 50 60 0.75\n").value;
  EXPECT_THAT(colorFirst.colors, ElementsAre(Color{10, 20, 30}, Color{40, 50, 60}));
  EXPECT_THAT(colorFirst.intensities, ElementsAre(0.5F, 0.75F));
}

TEST(ReadXyz, RecognizesAmbiguousColumnsByTheExtension) {
  const std::string text = "1 2 3 10 20 30 40\n4 5 6 50 60 70 80\n";
  EXPECT_THAT(importXyz(text, "oak.pts").value.colors,
              ElementsAre(Color{20, 30, 40}, Color{60, 70, 80}));
  EXPECT_THAT(importXyz(text, "oak.txt").value.colors,
              ElementsAre(Color{10, 20, 30}, Color{50, 60, 70}));
}

TEST(ReadXyz, NotesColumnsThatItLeavesOut) { // normals
  const Imported<RawPoints> points = importXyz("1 2 3 0.5 0.5 0.7\n4 5 6 0.1 0.2 0.9\n");
  EXPECT_THAT(points.value.intensities, IsEmpty());
  EXPECT_THAT(points.value.colors, IsEmpty());
  EXPECT_THAT(eachInEnglish(points.notes), ElementsAre(HasSubstr("3 of 6 columns are left out")));
}

TEST(ReadXyz, TakesColumnsByName) {
  const RawPoints points = importXyz("//X Y Z Nx Ny Nz Rf Gf Bf\n1 2 3 0 0 1 1 1 1\n").value;
  EXPECT_THAT(points.colors, IsEmpty()) << "these are no names of colors";
  const RawPoints named =
      importXyz(
          "time,x,y,z,Reflectance,red,green,blue\n99,1,2,3,-12.5,0,0.5,1\n98,1,2,3,-1,0,0,0\n")
          .value;
  EXPECT_THAT(named.positions, ElementsAre(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(1, 2, 3)));
  EXPECT_THAT(named.intensities, ElementsAre(-12.5F, -1.0F));
  EXPECT_THAT(named.colors, ElementsAre(Color{0, 128, 255}, Color{0, 0, 0}));
}

TEST(ReadXyz, NotesACountThatDoesNotHold) {
  EXPECT_THAT(eachInEnglish(importXyz("3\n1 2 3\n4 5 6\n", "oak.pts").notes),
              ElementsAre("oak.pts: promises 3 points, but lists 2"));
  EXPECT_EQ(importXyz("1000000000000\n1 2 3\n", "oak.pts").value.positions.size(), 1U);
}

TEST(ReadXyz, NamesTheLineThatIsNoPoint) {
  EXPECT_EQ(refusalOfXyz("1 2 3\n4 5\n"), "oak.xyz, line 2: expected 3 numbers, found 2");
  EXPECT_EQ(refusalOfXyz("1 2 3\n\n4 five 6\n"),
            "oak.xyz, line 3: expected a number, found 'five'");
  EXPECT_THAT(refusalOfXyz("Dear reader,\nthese are no numbers\n"),
              testing::StartsWith("oak.xyz, line "));
  EXPECT_THAT(refusalOfXyz("hello\n"), testing::StartsWith("oak.xyz, line 1: expected 3 numbers"));
  EXPECT_THAT(refusalOfXyz("1 2\n3 4\n"),
              testing::StartsWith("oak.xyz, line 1: expected 3 numbers, found 2"));
  EXPECT_THAT(refusalOfXyz("1,2 3.5,4 5\n"), testing::StartsWith("oak.xyz, line 1: "));
}

TEST(ReadXyz, RefusesAFileWithoutPoints) {
  EXPECT_THAT(refusalOfXyz(""), HasSubstr("holds no points"));
  EXPECT_THAT(refusalOfXyz("# only\n# remarks\n"), HasSubstr("holds no points"));
  EXPECT_THAT(refusalOfXyz("5\n"), HasSubstr("holds no points"));
  const std::string letter = "Dear friend,\nthe oak is well and green\nsince the 3rd of May\n";
  EXPECT_EQ(refusalOfXyz(letter), "oak.xyz, line 1: expected 3 numbers, found text, and no points "
                                  "follow");
}

TEST(ReadXyz, HandsOnPointsThatAreNotFinite) { // PointCloud leaves them out
  const RawPoints points = importXyz("nan 2 3\n4 -inf 6\n7 8 9\n").value;
  EXPECT_TRUE(std::isnan(points.positions.at(0).x()));
  EXPECT_TRUE(std::isinf(points.positions.at(1).y()));
}

TEST(ReadXyz, KeepsMillimetresOfLargeCoordinates) {
  const PointCloud cloud(
      importXyz("623456.789 5812345.678 104.321\n623460.123 5812349.456 110.987\n").value);
  EXPECT_LT((cloud.position(0) - Eigen::Vector3d(623456.789, 5812345.678, 104.321)).norm(), 1e-5);
}

TEST(WriteXyz, AndReadingGivesTheSameCloud) {
  Random random(2);
  RawPoints raw;
  for (int i = 0; i < 1000; ++i) {
    raw.positions.emplace_back(Eigen::Vector3d(600000, -5000000, 0) + 10 * random.direction());
    raw.colors.push_back({1, static_cast<std::uint8_t>(random.below(256)), 3});
    raw.intensities.push_back(static_cast<float>(random.uniform()));
  }
  const PointCloud cloud(raw);
  std::ostringstream out;
  writeXyz(out, cloud, cloud.positions());
  const RawPoints back = importXyz(out.str()).value;
  EXPECT_EQ(back.colors, raw.colors) << "in the order of the file";
  EXPECT_EQ(back.intensities, raw.intensities);
  EXPECT_EQ(PointCloud(back).positions(), cloud.positions()) << "bit for bit";
}

TEST(WriteXyz, WritesNoMoreDecimalsThanCame) {
  const std::string text = "-6.448 3.905 7.92\n-6.433 3.901 7\n";
  const PointCloud cloud(importXyz(text).value);
  std::ostringstream out;
  writeXyz(out, cloud, cloud.positions());
  EXPECT_EQ(out.str(), text);
}

} // namespace
} // namespace espalier
