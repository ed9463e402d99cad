#include "core/base/shown_message.h"
#include "core/io/points/ptx.h"
#include "tests/core/io/samples.h"

#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

Imported<RawPoints> importPtx(const std::string& text) {
  std::istringstream in(text);
  return readPtx(in, "tree.ptx");
}

std::string refusalOfPtx(const std::string& text) {
  return test::errorOf([&] { return importPtx(text); });
}

/// A block of one column; its matrix leaves all points where they are.
std::string blockOf(int rows, const std::string& lines) {
  return "1\n" + std::to_string(rows) +
         "\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n" + lines;
}

TEST(ReadPtx, MultipliesPointsAsRowsByTheMatrixOfTheirBlock) {
  const Imported<RawPoints> points = importPtx(test::ptxFile());
  EXPECT_THAT(points.value.positions,
              ElementsAre(Eigen::Vector3d(10, 21, 30), Eigen::Vector3d(9, 20, 30),
                          Eigen::Vector3d(10, 20, 31), Eigen::Vector3d(1, 2, 3),
                          Eigen::Vector3d(4, 5, 6), Eigen::Vector3d(7, 8, 9),
                          Eigen::Vector3d(0.001, 0, 0)));
  EXPECT_THAT(points.value.intensities, ElementsAre(0.5F, 0.25F, 1.0F, 0.5F, 0.25F, 0.0F, 1.0F));
  EXPECT_THAT(points.value.colors, ElementsAre(Color{10, 20, 30}, Color{1, 2, 3}, Color{255, 0, 0},
                                               Color{}, Color{}, Color{}, Color{}));
  EXPECT_THAT(eachInEnglish(points.notes),
              ElementsAre("tree.ptx: holds 2 stations, which are joined into one set of points",
                          "tree.ptx: no colors in 1 of 2 stations: points there are black",
                          "tree.ptx: 1 of 8 points have no return (0 0 0) and are left out"));
}

TEST(ReadPtx, KeepsWhichPointIsFromWhichStation) {
  const RawPoints points = importPtx(test::ptxFile()).value;
  EXPECT_THAT(points.stationOf, ElementsAre(0, 0, 0, 1, 1, 1, 1));
  ASSERT_THAT(points.stations, SizeIs(2));
  EXPECT_EQ(points.stations[0], (Station{"station 1", Eigen::Vector3d(10, 20, 30)}));
  EXPECT_EQ(points.stations[1], (Station{"station 2", Eigen::Vector3d(0, 0, 0)}));
}

TEST(ReadPtx, TakesThePlaceOfTheScannerFromItsLine) {
  std::string text = blockOf(1, "1 2 3 4\n");
  text.replace(text.find("0 0 0"), 5, "7 8 9");
  const RawPoints points = importPtx(text).value;
  EXPECT_THAT(points.stations, ElementsAre(Station{"station 1", Eigen::Vector3d(7, 8, 9)}));
  EXPECT_THAT(points.stationOf, IsEmpty());
}

// The example by which LAStools shows what a matrix does, with the result it prints.
TEST(ReadPtx, AgreesWithLastools) {
  std::string text = "1\n2\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n-0.955179 0.296021 -0.002106 0\n"
                     "-0.296023 -0.955180 0.001152 0\n-0.001670 0.001724 0.999997 0\n"
                     "3.847211 12.235314 -0.425777 1\n1.111111 2.111111 3.111 0.111\n"
                     "1.666666 2.666666 3.666 0.678\n";
  const RawPoints points = importPtx(text).value;
  EXPECT_LT((points.positions[0] - Eigen::Vector3d(2.156, 10.553, 2.685)).norm(), 1e-3);
  EXPECT_LT((points.positions[1] - Eigen::Vector3d(1.460, 10.188, 3.240)).norm(), 1e-3);
}

TEST(ReadPtx, TakesLinesWithoutAReturnThatAreShorter) {
  const RawPoints points = importPtx(blockOf(3, "0 0 0 0.5\n1 2 3 0.5 10 20 30\n0 0 0\n")).value;
  EXPECT_THAT(points.positions, ElementsAre(Eigen::Vector3d(1, 2, 3)));
  EXPECT_THAT(points.colors, ElementsAre(Color{10, 20, 30}));
}

TEST(ReadPtx, TakesPositionsAloneAndColorsAsFractions) {
  EXPECT_THAT(importPtx(blockOf(1, "1 2 3")).value.intensities, IsEmpty());
  EXPECT_THAT(importPtx(blockOf(1, "1 2 3 0.5 1 0.5 0\r\n")).value.colors,
              ElementsAre(Color{255, 128, 0}));
}

TEST(ReadPtx, TakesBlocksWithoutPoints) {
  EXPECT_THAT(importPtx(blockOf(0, "") + "\n" + blockOf(1, "1 2 3 4\n\n")).value.positions,
              SizeIs(1));
  EXPECT_THAT(importPtx("").value.positions, IsEmpty());
}

TEST(ReadPtx, NamesTheLineThatIsWrong) {
  EXPECT_EQ(refusalOfPtx("many\n"), "tree.ptx, line 1: expected a number, found 'many'");
  EXPECT_THAT(refusalOfPtx("1.5\n"), HasSubstr("line 1: expected a whole number of columns"));
  EXPECT_THAT(refusalOfPtx("-1\n"), HasSubstr("line 1: expected a whole number of columns"));
  EXPECT_EQ(refusalOfPtx("1\n1\n0 0\n"), "tree.ptx, line 3: expected 3 numbers, found 2");
  EXPECT_EQ(refusalOfPtx(blockOf(2, "1 2 3 4\n5 6\n")),
            "tree.ptx, line 12: expected 3 numbers, found 2");
  EXPECT_EQ(refusalOfPtx(blockOf(2, "1 2 3 4\n5 6 x 7\n")),
            "tree.ptx, line 12: expected a number, found 'x'");
  EXPECT_THAT(refusalOfPtx(blockOf(1, "1 2 3 4 5\n")),
              HasSubstr("line 11: expected x y z, intensity and red green blue"));
  EXPECT_EQ(refusalOfPtx(blockOf(2, "1 2 3 4\n1 2 3\n")),
            "tree.ptx, line 12: expected 4 numbers as in the lines before, found 3");
  EXPECT_THAT(refusalOfPtx("1\n1\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n1 0 0 0\n0 0 1 0\n0 0 0 1\n"
                           "1 2 3 4\n"),
              HasSubstr("line 10: the matrix that ends here"));
}

TEST(ReadPtx, RefusesAFileCutShort) {
  EXPECT_THAT(refusalOfPtx("1\n1\n0 0 0\n"), HasSubstr("ends within the header of a block"));
  EXPECT_THAT(refusalOfPtx(blockOf(2, "1.000 2.000 3.000 4.000\n")),
              HasSubstr("ends after 1 of 2 points"));
}

TEST(ReadPtx, DoesNotTrustItsHeader) {
  EXPECT_THAT(refusalOfPtx("4294967295\n4294967295\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n"
                           "0 0 1 0\n0 0 0 1\n1 2 3 4\n"),
              HasSubstr("tree.ptx, line 10: its header promises 18446744065119617025 points"));
  EXPECT_THAT(refusalOfPtx("1e20\n"), HasSubstr("line 1: expected a whole number"));
}

TEST(ReadPtx, IsKnownByItsFirstTenLines) {
  EXPECT_TRUE(isPtx(test::ptxFile()));
  EXPECT_FALSE(isPtx("2\n1 2 3\n4 5 6\n"));
  EXPECT_FALSE(isPtx(test::xyzFile()));
}

TEST(ReadPtx, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  std::istringstream in(test::ptxFile());
  EXPECT_THROW((void)readPtx(in, "tree.ptx", {}, Progress(stop.get_token(), {})), Cancelled);
}

} // namespace
} // namespace espalier
