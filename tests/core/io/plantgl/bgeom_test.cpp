#include "core/base/shown_message.h"
#include "core/io/formats.h"
#include "core/io/plantgl/bgeom.h"
#include "tests/core/io/plantgl/bgeom_writer.h"
#include "tests/core/io/samples.h"
#include "tests/support/shared_data.h"

#include <cmath>
#include <gmock/gmock.h>
#include <numbers>
#include <sstream>

namespace espalier {
namespace {

using test::BgeomWriter;
using test::uint32Bytes;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

using Points = std::vector<Eigen::Vector3d>;

Imported<RawPoints> importBgeom(const std::string& bytes) {
  std::istringstream in(bytes);
  return readBgeom(in, "oak.bgeom");
}

std::string refusalOfBgeom(const std::string& bytes) {
  return test::errorOf([&] { return importBgeom(bytes); });
}

class ReadBgeomOfAnyVersion : public testing::TestWithParam<int> {};

TEST_P(ReadBgeomOfAnyVersion, FindsPointsOfBothPrecisions) {
  for (const int bits : {32, 64}) {
    if (bits == 64 && GetParam() < 16) continue; // it came with version 1.6
    const BgeomWriter out{.version = GetParam(), .bits = bits};
    const Imported<RawPoints> points =
        importBgeom(out.file(out.shapeOf(out.points({1, 2, 3, -4, 0.5, 6}, {}, 3)) +
                             out.shapeOf(BgeomWriter::reference + uint32Bytes(3))));
    EXPECT_EQ(points.value.positions, (Points{{1, 2, 3}, {-4, 0.5, 6}, {1, 2, 3}, {-4, 0.5, 6}}));
    EXPECT_THAT(points.value.colors, IsEmpty());
    EXPECT_THAT(points.notes, IsEmpty());
  }
}

INSTANTIATE_TEST_SUITE_P(All, ReadBgeomOfAnyVersion,
                         testing::Values(10, 11, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25));

TEST(ReadBgeom, MovesAndScalesPointsAndKeepsTheirColors) {
  const Imported<RawPoints> points = importBgeom(test::bgeomFile());
  EXPECT_EQ(points.value.positions, (Points{{11, 2, 3}, {14, 5, 6}, {1, 2, 3}, {4, 5, 6}}));
  EXPECT_THAT(points.value.colors, ElementsAre(Color{10, 20, 30}, Color{40, 50, 60},
                                               Color{10, 20, 30}, Color{40, 50, 60}));
  EXPECT_THAT(eachInEnglish(points.notes),
              ElementsAre("oak.bgeom: objects that are no point sets are passed "
                          "over: 'Sphere'"));
}

// A point at x is first scaled, then moved, then scaled again: 2 (3 x + 10).
TEST(ReadBgeom, PlacesFromTheInsideOut) {
  const BgeomWriter out;
  const std::string inner =
      out.begin(BgeomWriter::scaled) + out.reals({3, 1, 1}) + out.points({1, 1, 1});
  const std::string moved = out.begin(BgeomWriter::translated) + out.reals({10, 0, -1}) + inner;
  const std::string outer = out.begin(BgeomWriter::scaled) + out.reals({2, 1, 5}) + moved;
  EXPECT_EQ(importBgeom(out.file(out.shapeOf(outer))).value.positions, (Points{{26, 1, 0}}));
}

TEST(ReadBgeom, TakesSetsWithoutColorsAsWhiteAmongColored) {
  const BgeomWriter out;
  const RawPoints points = importBgeom(out.file(out.shapeOf(out.points({1, 1, 1})) +
                                                out.shapeOf(out.points({2, 2, 2}, {{1, 2, 3}}))))
                               .value;
  EXPECT_THAT(points.colors, ElementsAre(Color{255, 255, 255}, Color{1, 2, 3}));
}

TEST(ReadBgeom, DropsColorsThatDoNotMatchThePoints) {
  const BgeomWriter out;
  const Imported<RawPoints> points =
      importBgeom(out.file(out.shapeOf(out.points({1, 1, 1, 2, 2, 2}, {{1, 2, 3}}))));
  EXPECT_EQ(points.value.positions.size(), 2U);
  EXPECT_THAT(points.value.colors, IsEmpty());
  EXPECT_THAT(eachInEnglish(points.notes),
              ElementsAre(HasSubstr("1 point set has another number of colors")));
}

TEST(ReadBgeom, PassesOverMeshesAndMaterialsOfAnyKind) {
  const BgeomWriter out;
  const std::string mesh = out.begin(BgeomWriter::triangleSet) +
                           std::string("\xff\x06", 2) + // all by default but the colors
                           uint32Bytes(3) + out.reals({0, 0, 0, 1, 0, 0, 0, 1, 0}) +
                           uint32Bytes(1) + uint32Bytes(0) + uint32Bytes(1) + uint32Bytes(2) +
                           uint32Bytes(1) + "rgba";
  std::string material = out.begin(BgeomWriter::material);
  material += '\0'; // nothing by default
  material += "rgb" + out.reals({0.5}) + "rgbrgb" + out.reals({1, 0});
  std::string shape = out.shapeOf(mesh);
  shape.resize(shape.size() - out.defaultMaterial().size());
  const Imported<RawPoints> points =
      importBgeom(out.file(shape + material + out.shapeOf(out.points({1, 2, 3}))));
  EXPECT_EQ(points.value.positions, (Points{{1, 2, 3}}));
  EXPECT_THAT(eachInEnglish(points.notes), ElementsAre(HasSubstr("passed over: 'TriangleSet'")));
}

constexpr double quarter = std::numbers::pi / 2;

/// Where an object of this type, with the bytes of its fields, puts (1, 2, 3).
Eigen::Vector3d turned(char type, const std::string& fields) {
  const BgeomWriter out;
  const std::string object = out.begin(type) + fields + out.points({1, 2, 3});
  const Points points = importBgeom(out.file(out.shapeOf(object))).value.positions;
  return points.size() == 1 ? points[0] : Eigen::Vector3d::Constant(NAN);
}

// Bits of the first byte say which fields are left at their defaults: about z, by nothing.
TEST(ReadBgeom, TurnsPointsAboutAnAxis) {
  const BgeomWriter out;
  const auto about = [&](const std::string& fields) {
    return turned(BgeomWriter::axisRotated, fields);
  };
  EXPECT_TRUE(about("\x01" + out.reals({quarter})).isApprox(Eigen::Vector3d(-2, 1, 3)));
  EXPECT_TRUE(about(std::string(1, '\0') + out.reals({5, 0, 0, quarter}))
                  .isApprox(Eigen::Vector3d(1, -3, 2)));
  EXPECT_EQ(about("\x03"), Eigen::Vector3d(1, 2, 3));
}

// By the roll about x, (1, 2, 3) comes to (1, -3, 2), then by the azimuth about z to (3, 1, 2).
TEST(ReadBgeom, TurnsPointsByRollThenElevationThenAzimuth) {
  const BgeomWriter out;
  const auto by = [&](const std::string& fields) {
    return turned(BgeomWriter::eulerRotated, fields);
  };
  EXPECT_TRUE(by("\x02" + out.reals({quarter, quarter})).isApprox(Eigen::Vector3d(3, 1, 2)));
  EXPECT_TRUE(by("\x05" + out.reals({quarter})).isApprox(Eigen::Vector3d(3, 2, -1)));
}

TEST(ReadBgeom, TurnsPointsToDirections) {
  const BgeomWriter out;
  const auto to = [&](const std::string& fields) { return turned(BgeomWriter::oriented, fields); };
  EXPECT_TRUE(
      to(std::string(1, '\0') + out.reals({0, 1, 0, 0, 0, 1})).isApprox(Eigen::Vector3d(3, 1, 2)));
  EXPECT_TRUE(to("\x01" + out.reals({0, 0, 2})).isApprox(Eigen::Vector3d(1, -3, 2)));
}

TEST(ReadBgeom, LeavesOutPointsThatTheSceneBendsOrTurnsInNoClearWay) {
  const BgeomWriter out;
  const std::string bent = out.begin(BgeomWriter::tapered) + "\x03" + out.points({1, 2, 3});
  const std::string unclear = out.begin(BgeomWriter::oriented) + std::string(1, '\0') +
                              out.reals({1, 1, 0, 0, 1, 0}) + out.points({1, 2, 3});
  const Imported<RawPoints> points = importBgeom(
      out.file(out.shapeOf(bent) + out.shapeOf(unclear) + out.shapeOf(out.points({4, 5, 6}))));
  EXPECT_EQ(points.value.positions, (Points{{4, 5, 6}}));
  EXPECT_THAT(eachInEnglish(points.notes),
              ElementsAre(HasSubstr("passed over: 'Tapered'"),
                          HasSubstr("2 points in objects that the scene bends")));
}

TEST(ReadBgeom, RefusesWhatItCannotRead) {
  const BgeomWriter out;
  EXPECT_THAT(refusalOfBgeom("!bGEO"), HasSubstr("no binary scene of PlantGL"));
  EXPECT_THAT(refusalOfBgeom(BgeomWriter{.version = 26}.file("")), HasSubstr("is version 2.6"));
  EXPECT_THAT(refusalOfBgeom(BgeomWriter{.bits = 33}.file("")), HasSubstr("reals of 33 bits"));
  std::string bytes = out.file("");
  bytes.erase(10, 1); // the \r
  EXPECT_THAT(refusalOfBgeom(bytes), HasSubstr("byte 12: its line end was changed"));
  EXPECT_THAT(refusalOfBgeom(std::string("!bGEOM\0\0\xc0\x7f", 10)), HasSubstr("is no version"));
  EXPECT_THAT(refusalOfBgeom(out.file("\x63")), HasSubstr("an object is of no type known"));
  EXPECT_THAT(refusalOfBgeom(out.file(out.begin(BgeomWriter::teapot))),
              HasSubstr("'Teapot' whose size is not known in version 2.4"));
  const BgeomWriter old{.version = 14, .bits = 32};
  EXPECT_THAT(refusalOfBgeom(old.file(old.begin(BgeomWriter::triangleSet))),
              HasSubstr("'TriangleSet' whose size is not known in version 1.4"));
  EXPECT_THAT(refusalOfBgeom(out.file(out.shapeOf(BgeomWriter::reference + uint32Bytes(9)))),
              HasSubstr("refers to an object that does not come before"));
}

TEST(ReadBgeom, RefusesAFileCutShortAnywhere) {
  const std::string bytes = test::bgeomFile();
  const std::size_t secondShape =
      bytes.rfind("leaf") - 3; // before it, the file is one of one shape
  const std::size_t start = bytes.find("leaf") - 3;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    if (size == start || size == secondShape) continue;
    EXPECT_NE(refusalOfBgeom(bytes.substr(0, size)), "") << size;
  }
}

TEST(ReadBgeom, DoesNotTrustItsCounts) {
  const BgeomWriter out;
  EXPECT_THAT(refusalOfBgeom(out.file(out.begin(BgeomWriter::pointSet) + uint32Bytes(0xffffffff))),
              HasSubstr("ends within a value of 103079215080 bytes"));
  EXPECT_THAT(
      refusalOfBgeom(out.file(out.begin(BgeomWriter::group) + "\xff" + uint32Bytes(0xffffffff))),
      HasSubstr("cut short"));
}

TEST(ReadBgeom, RefusesDepthsThatNoSceneHas) {
  const BgeomWriter out;
  const std::string level = out.begin(BgeomWriter::translated) + out.reals({1, 0, 0});
  std::string nested;
  for (int i = 0; i < 1000; ++i)
    nested += level;
  EXPECT_THAT(refusalOfBgeom(out.file(nested)), HasSubstr("nested deeper than 64"));
  std::string chain = out.points({1, 2, 3}, {}, 1); // deep through references
  for (std::uint32_t i = 2; i < 100; ++i)
    chain += out.begin(BgeomWriter::translated, i) + out.reals({1, 0, 0}) + BgeomWriter::reference +
             uint32Bytes(i - 1);
  EXPECT_THAT(refusalOfBgeom(out.file(chain)), HasSubstr("nested deeper than 64"));
}

// Each of 40 groups holds the one before twice: 2^40 points.
TEST(ReadBgeom, RefusesPointsThatGrowByBeingShared) {
  const BgeomWriter out;
  std::string objects = out.points({1, 2, 3}, {}, 1);
  for (std::uint32_t i = 2; i < 42; ++i) {
    const std::string before = BgeomWriter::reference + uint32Bytes(i - 1);
    objects += out.begin(BgeomWriter::group, i) + "\xff" + uint32Bytes(2) + before + before;
  }
  EXPECT_THAT(
      refusalOfBgeom(out.file(objects + out.shapeOf(BgeomWriter::reference + uint32Bytes(41)))),
      HasSubstr("repeats its 1 points more than 16 times"));
}

TEST(ReadBgeom, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  std::istringstream in(test::bgeomFile());
  EXPECT_THROW((void)readBgeom(in, "oak.bgeom", Progress(stop.get_token(), {})), Cancelled);
}

TEST(ReadBgeom, EqualsTheSameCloudAsPly) {
  ESPALIER_SHARED_FILE(binary, "plantscan3d/branch-demo.bgeom");
  ESPALIER_SHARED_FILE(ply, "branch-demo/scan.ply");
  const Imported<PointCloud> cloud = readPoints(binary);
  EXPECT_EQ(formatOf(binary).name, "BGEOM");
  const PointCloud twin = readPoints(ply).value;
  EXPECT_EQ(cloud.value.size(), 4959);
  EXPECT_EQ(cloud.value.positions(), twin.positions());
  EXPECT_EQ(cloud.value.origin(), twin.origin());
  EXPECT_EQ(cloud.value.fileOrder(), twin.fileOrder());
  EXPECT_THAT(cloud.notes, IsEmpty());
}

} // namespace
} // namespace espalier
