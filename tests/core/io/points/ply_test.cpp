#include "core/base/random.h"
#include "core/base/shown_message.h"
#include "core/io/points/ply.h"
#include "tests/core/io/samples.h"

#include <cmath>
#include <gmock/gmock.h>
#include <limits>
#include <sstream>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Imported<RawPoints> importPly(const std::string& bytes) {
  std::istringstream in(bytes);
  return readPly(in, "tree.ply");
}

std::string refusalOfPly(const std::string& bytes) {
  return test::errorOf([&] { return importPly(bytes); });
}

std::string joined(std::initializer_list<std::string_view> parts) {
  std::string text;
  for (const std::string_view part : parts)
    text += part;
  return text;
}

/// A binary file whose points have the properties `header`, with `data` after it.
std::string binary(const std::string& header, const std::string& data) {
  return "ply\nformat binary_little_endian 1.0\n" + header + "end_header\n" + data;
}

RawPoints threeStations() {
  RawPoints raw;
  for (int i = 0; i < 6; ++i) {
    raw.positions.emplace_back(i, 0, 0);
    raw.stationOf.push_back(static_cast<StationIndex>(i % 3));
  }
  raw.stations = {{"from the\nnorth", Eigen::Vector3d(500'000.125, -2, 1e-3)}, {"", {}}, {"c", {}}};
  return raw;
}

TEST(WritePly, KeepsStationsAndWhereScannersStood) {
  const PointCloud cloud(threeStations());
  std::ostringstream out;
  writePly(out, cloud, cloud.positions());
  const RawPoints points = importPly(out.str()).value;
  EXPECT_THAT(points.stationOf, ElementsAre(0, 1, 2, 0, 1, 2));
  EXPECT_THAT(points.stations,
              ElementsAre(Station{"from the north", Eigen::Vector3d(500'000.125, -2, 1e-3)},
                          Station{"", {}}, Station{"c", {}}));
}

TEST(ReadPly, NamesStationsByTheirNumbersWithoutComments) {
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                             "property float y\nproperty float z\nproperty float scalar_station\n"
                             "end_header\n";
  const RawPoints points = importPly(header + "0 0 0 7\n1 0 0 300\n2 0 0 7\n").value;
  EXPECT_THAT(points.stationOf, ElementsAre(0, 1, 0));
  EXPECT_THAT(points.stations, ElementsAre(Station{"station 7", {}}, Station{"station 300", {}}));
  EXPECT_TRUE(importPly(header + "0 0 0 7\n1 0 0 0.5\n2 0 0 7\n").value.stations.empty());
  EXPECT_TRUE(importPly(header + "0 0 0 7\n1 0 0 -1\n2 0 0 7\n").value.stationOf.empty());
  EXPECT_THAT(importPly(header + "0 0 0 7\n1 0 0 7\n2 0 0 7\n").value.stationOf,
              testing::IsEmpty());
}

class ReadPlyOfEitherOrder : public testing::TestWithParam<std::endian> {};

TEST_P(ReadPlyOfEitherOrder, TakesAnyTypesAndPassesOverTheRest) {
  const Imported<RawPoints> points = importPly(test::plyFile(GetParam()));
  EXPECT_THAT(points.value.positions,
              ElementsAre(Eigen::Vector3d(-1, 100000, 0), Eigen::Vector3d(-2, 100001, 0.25),
                          Eigen::Vector3d(-3, 100002, 0.5)));
  EXPECT_THAT(points.value.colors,
              ElementsAre(Color{10, 20, 30}, Color{11, 20, 30}, Color{12, 20, 30}));
  EXPECT_THAT(points.value.intensities, ElementsAre(0.0F, 0.5F, 1.0F));
  EXPECT_THAT(eachInEnglish(points.notes), ElementsAre(HasSubstr("is a mesh: 1 face left out")));
}

TEST_P(ReadPlyOfEitherOrder, RefusesAFileCutShortAnywhereInItsPoints) {
  const std::string bytes = test::plyFile(GetParam());
  constexpr std::size_t faceBytes = 13;
  for (std::size_t size = bytes.find("end_header"); size < bytes.size() - faceBytes; ++size)
    EXPECT_NE(refusalOfPly(bytes.substr(0, size)), "") << size;
}

INSTANTIATE_TEST_SUITE_P(Orders, ReadPlyOfEitherOrder,
                         testing::Values(std::endian::little, std::endian::big));

struct NamedType {
  const char* name;
  ScalarType type;
};

void PrintTo(const NamedType& type, std::ostream* out) {
  *out << type.name;
}

class ReadPlyType : public testing::TestWithParam<NamedType> {};

TEST_P(ReadPlyType, TakesItForCoordinates) {
  const auto [name, type] = GetParam();
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    std::string bytes = joined({"ply\nformat binary_", order == std::endian::big ? "big" : "little",
                                "_endian 1.0\nelement vertex 1\nproperty ", name, " x\nproperty ",
                                name, " y\nproperty ", name, " z\nend_header\n"});
    for (const int value : {1, 2, 100}) {
      switch (type) {
      case ScalarType::int8:
        appendValue(bytes, static_cast<std::int8_t>(value), order);
        break;
      case ScalarType::uint8:
        appendValue(bytes, static_cast<std::uint8_t>(value), order);
        break;
      case ScalarType::int16:
        appendValue(bytes, static_cast<std::int16_t>(value), order);
        break;
      case ScalarType::uint16:
        appendValue(bytes, static_cast<std::uint16_t>(value), order);
        break;
      case ScalarType::int32:
        appendValue(bytes, static_cast<std::int32_t>(value), order);
        break;
      case ScalarType::uint32:
        appendValue(bytes, static_cast<std::uint32_t>(value), order);
        break;
      case ScalarType::int64:
        appendValue(bytes, static_cast<std::int64_t>(value), order);
        break;
      case ScalarType::uint64:
        appendValue(bytes, static_cast<std::uint64_t>(value), order);
        break;
      case ScalarType::float32:
        appendValue(bytes, static_cast<float>(value), order);
        break;
      case ScalarType::float64:
        appendValue(bytes, static_cast<double>(value), order);
        break;
      }
    }
    EXPECT_THAT(importPly(bytes).value.positions, ElementsAre(Eigen::Vector3d(1, 2, 100)));
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, ReadPlyType,
    testing::Values(
        NamedType{"char", ScalarType::int8}, NamedType{"int8", ScalarType::int8},
        NamedType{"uchar", ScalarType::uint8}, NamedType{"uint8", ScalarType::uint8},
        NamedType{"short", ScalarType::int16}, NamedType{"int16", ScalarType::int16},
        NamedType{"ushort", ScalarType::uint16}, NamedType{"uint16", ScalarType::uint16},
        NamedType{"int", ScalarType::int32}, NamedType{"int32", ScalarType::int32},
        NamedType{"uint", ScalarType::uint32}, NamedType{"uint32", ScalarType::uint32},
        NamedType{"int64", ScalarType::int64}, NamedType{"uint64", ScalarType::uint64},
        NamedType{"float", ScalarType::float32}, NamedType{"float32", ScalarType::float32},
        NamedType{"double", ScalarType::float64}, NamedType{"float64", ScalarType::float64}));

TEST(ReadPly, TakesTextWithListsAndFractionsAsColors) {
  const RawPoints points = importPly(test::asciiPlyFile()).value;
  EXPECT_THAT(points.positions,
              ElementsAre(Eigen::Vector3d(500000.125, 1, 2), Eigen::Vector3d(-0.001, 2, 3),
                          Eigen::Vector3d(4, 5, 6)));
  EXPECT_THAT(points.colors, ElementsAre(Color{0, 128, 255}, Color{0, 0, 0}, Color{255, 255, 255}));
}

TEST(ReadPly, NamesTheLineOfTextThatIsWrong) {
  const std::string header = "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\n"
                             "property float y\nproperty float z\nend_header\n";
  EXPECT_EQ(refusalOfPly(header + "1 2 3\n4 5\n      "),
            "tree.ply, line 9: expected 3 numbers, found 2");
  EXPECT_EQ(refusalOfPly(header + "1 2 3\n4 five 6\n"),
            "tree.ply, line 9: expected a number, found 'five'");
  EXPECT_THAT(refusalOfPly(header + "1.000000 2.000000 3.000000\n"),
              HasSubstr("within vertex 2 of 2"));
}

TEST(ReadPly, NamesTheLineOfTheHeaderThatIsWrong) {
  EXPECT_THAT(refusalOfPly(""), HasSubstr("first line is not 'ply'"));
  EXPECT_THAT(refusalOfPly("ply\nformat ascii 1.0\n"), HasSubstr("no line 'end_header'"));
  EXPECT_THAT(refusalOfPly("ply\nend_header\n"),
              HasSubstr("line 2: the header has no line 'format'"));
  EXPECT_THAT(refusalOfPly("ply\nformat utf8 1.0\n"), HasSubstr("line 2: the format 'utf8'"));
  EXPECT_THAT(refusalOfPly(binary("element vertex x\n", "")), HasSubstr("line 3: expected a name"));
  EXPECT_THAT(refusalOfPly(binary("property float x\n", "")), HasSubstr("line 3: a property"));
  EXPECT_THAT(refusalOfPly(binary("element vertex 1\nproperty real x\n", "")),
              HasSubstr("line 4: 'real' is no type"));
  EXPECT_THAT(refusalOfPly(binary("element vertex 1\nproperty list float int x\n", "")),
              HasSubstr("line 4: the length of a list"));
  EXPECT_THAT(refusalOfPly(binary("element vertex 1\nproperty float x\n", "    ")),
              HasSubstr("no property 'y'"));
  EXPECT_THAT(refusalOfPly(binary("element edge 0\n", "")), HasSubstr("no element 'vertex'"));
  EXPECT_THAT(refusalOfPly(binary("vertices 3\n", "")), HasSubstr("line 3: 'vertices' is unknown"));
}

TEST(ReadPly, DoesNotTrustItsHeader) {
  for (const std::string_view format : {"ascii", "binary_little_endian"}) {
    const auto file = [&](std::string_view elements) {
      return joined({"ply\nformat ", format, " 1.0\n", elements,
                     "property float x\nproperty float y\nproperty float z\nend_header\n1 2 3\n"});
    };
    EXPECT_THAT(refusalOfPly(file("element vertex 1000000000000\n")),
                HasSubstr("promises 1000000000000 points"));
    EXPECT_NE(refusalOfPly(file("element face 1000000000000\nproperty list uchar int i\n"
                                "element vertex 1\n")),
              "");
    EXPECT_NE(refusalOfPly(file("element other 1000000000000\nproperty double i\n"
                                "element vertex 1\n")),
              "");
  }
}

TEST(ReadPly, HandsOnPointsThatAreNotFinite) { // PointCloud leaves them out
  std::string data;
  for (const float value : {1.0F, std::numeric_limits<float>::quiet_NaN(), 3.0F})
    appendValue(data, value);
  const RawPoints points =
      importPly(
          binary("element vertex 1\nproperty float x\nproperty float y\nproperty float z\n", data))
          .value;
  EXPECT_TRUE(std::isnan(points.positions.at(0).y()));
}

TEST(WritePly, AndReadingGivesTheSameCloudInTheOrderOfTheFile) {
  Random random(1);
  RawPoints raw;
  for (int i = 0; i < 1000; ++i) {
    raw.positions.emplace_back(Eigen::Vector3d(600000, 5000000, 100) + 10 * random.direction());
    raw.colors.push_back({static_cast<std::uint8_t>(random.below(256)), 2, 3});
    raw.intensities.push_back(static_cast<float>(random.uniform()));
  }
  raw.positions[17].x() = std::numeric_limits<double>::infinity();
  const PointCloud cloud(raw);
  std::ostringstream out;
  writePly(out, cloud, cloud.positions());
  const RawPoints back = importPly(out.str()).value;
  ASSERT_EQ(back.positions.size(), 999U);
  EXPECT_LT((back.positions[500] - raw.positions[501]).norm(), 1e-5);
  EXPECT_EQ(back.colors[500], raw.colors[501]);
  EXPECT_EQ(back.intensities[500], raw.intensities[501]);
  EXPECT_EQ(PointCloud(back).positions(), cloud.positions()) << "bit for bit";
}

TEST(WritePly, WritesMovedPointsToo) {
  const PointCloud cloud(RawPoints{.positions = {{1, 2, 3}, {4, 5, 6}}});
  std::ostringstream out;
  writePly(out, cloud, cloud.positions().array() + 1);
  EXPECT_THAT(importPly(out.str()).value.positions,
              ElementsAre(Eigen::Vector3d(2, 3, 4), Eigen::Vector3d(5, 6, 7)));
}

// Linear: by now it would take minutes otherwise.
TEST(ReadPly, TakesAHeaderOfVeryManyProperties) {
  std::string header = "ply\nformat binary_little_endian 1.0\nelement vertex 1\n";
  for (const char* name : {"x", "y", "z"})
    header += std::string("property float ") + name + '\n';
  constexpr int more = 500'000;
  for (int i = 0; i < more; ++i)
    header += "property char p" + std::to_string(i) + '\n';
  EXPECT_EQ(
      importPly(header + "end_header\n" + std::string(12 + more, '\0')).value.positions.size(), 1U);
}

} // namespace
} // namespace espalier
