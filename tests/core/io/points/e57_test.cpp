#include "core/base/shown_message.h"
#include "core/io/formats.h"
#include "core/io/points/e57.h"
#include "tests/core/io/points/e57_writer.h"
#include "tests/core/io/samples.h"
#include "tests/support/shared_data.h"

#include <Eigen/Geometry>

#include <cmath>
#include <fstream>
#include <gmock/gmock.h>
#include <limits>
#include <numbers>
#include <sstream>

namespace espalier {
namespace {

using test::cartesianColumns;
using test::E57Column;
using test::e57Content;
using test::e57File;
using test::E57Packing;
using test::E57Sample;
using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

Imported<RawPoints> importE57(const std::string& bytes) {
  std::istringstream in(bytes);
  return readE57(in, "tree.e57");
}

std::string refusalOfE57(const std::string& bytes) {
  return test::errorOf([&] { return importE57(bytes); });
}

/// `count` values from `first` on, each `step` further.
std::vector<double> series(int count, double first, double step) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i)
    values.push_back(first + step * i);
  return values;
}

/// 100 points whose x is 1, 2, 3 ...
E57Sample plainSample() {
  return {.columns = cartesianColumns(series(100, 1, 1), series(100, 0, 0), series(100, 0, 0))};
}

/// The file after `from` of its content became `to`, which is as long; its checksums fit again.
std::string altered(const std::string& file, std::string_view from, std::string_view to) {
  const std::string content = e57Content(file);
  const std::size_t at = content.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  EXPECT_EQ(from.size(), to.size());
  std::string changed = file;
  for (std::size_t i = 0; i < to.size(); ++i)
    changed[(at + i) / 1020 * 1024 + (at + i) % 1020] = to[i];
  return test::withChecksums(changed);
}

class ReadE57OfWidth : public testing::TestWithParam<unsigned> {};

// Values that begin in one packet and end in the next, too: 7 bytes of each stream are in a packet.
TEST_P(ReadE57OfWidth, UnpacksIntegersAndFindsThemWhereverTheyBegin) {
  const unsigned width = GetParam();
  const std::int64_t most = (std::int64_t{1} << width) - 1;
  E57Sample sample = plainSample();
  std::vector<double> values;
  for (std::int64_t i = 0; i < 100; ++i)
    values.push_back(static_cast<double>(-5 + (i * 2654435761 & most)));
  sample.columns[1] = {"cartesianY", E57Packing::integer, values, -5, most - 5};
  sample.columns[2] = {"cartesianZ", E57Packing::scaledInteger, values, -5, most - 5, 0.5, 100};
  for (const std::size_t bytes : {7U, 64U, 1000U}) {
    sample.bytesPerPacket = bytes;
    const RawPoints points = importE57(e57File({sample})).value;
    ASSERT_THAT(points.positions, SizeIs(100));
    for (std::size_t i = 0; i < 100; ++i)
      ASSERT_EQ(points.positions[i],
                Eigen::Vector3d(static_cast<double>(i) + 1, values[i], 100 + 0.5 * values[i]));
  }
}

INSTANTIATE_TEST_SUITE_P(All, ReadE57OfWidth,
                         testing::Values(0U, 1U, 2U, 3U, 5U, 7U, 8U, 9U, 12U, 15U, 16U, 17U, 23U,
                                         24U, 31U, 32U, 33U, 41U, 47U, 48U, 52U));

TEST(ReadE57, TakesIntegersOf64BitsWithoutLimits) {
  E57Sample sample = plainSample();
  const std::vector<double> values = series(100, -5e9, 1e9);
  sample.columns[1] = {"cartesianY", E57Packing::integer, values,
                       std::numeric_limits<std::int64_t>::min(),
                       std::numeric_limits<std::int64_t>::max()};
  sample.bytesPerPacket = 13;
  const RawPoints points = importE57(e57File({sample})).value;
  for (std::size_t i = 0; i < 100; ++i)
    ASSERT_EQ(points.positions[i].y(), values[i]);
}

TEST(ReadE57, TakesFloatsOfBothPrecisions) {
  E57Sample sample = plainSample();
  sample.columns[0].values = series(100, 500000.125, 0.001);
  sample.columns[2].values = series(100, -3, 0.25);
  sample.columns[2].packing = E57Packing::single;
  const RawPoints points = importE57(e57File({sample})).value;
  EXPECT_EQ(points.positions[99].x(), sample.columns[0].values[99]);
  EXPECT_EQ(points.positions[99].z(), 21.75);
}

TEST(ReadE57, TurnsAndMovesEachStationByItsPose) {
  const double half = std::sqrt(0.5);
  E57Sample turned{.columns = cartesianColumns({1, 0}, {0, 1}, {0, 0}),
                   .more = test::e57Pose(half, 0, 0, half, 10, 20, 30)}; // x to y
  E57Sample plain{.columns = cartesianColumns({1, 0}, {0, 1}, {0, 0})};
  const Imported<RawPoints> points = importE57(e57File({turned, plain}));
  ASSERT_THAT(points.value.positions, SizeIs(4));
  EXPECT_LT((points.value.positions[0] - Eigen::Vector3d(10, 21, 30)).norm(), 1e-12);
  EXPECT_LT((points.value.positions[1] - Eigen::Vector3d(9, 20, 30)).norm(), 1e-12);
  EXPECT_EQ(points.value.positions[2], Eigen::Vector3d(1, 0, 0));
  EXPECT_THAT(points.value.stationOf, ElementsAre(0, 0, 1, 1));
  EXPECT_THAT(points.value.stations, ElementsAre(Station{"station 1", Eigen::Vector3d(10, 20, 30)},
                                                 Station{"station 2", std::nullopt}));
  EXPECT_THAT(eachInEnglish(points.notes),
              ElementsAre("tree.e57: holds 2 stations, which are joined into one set "
                          "of points"));
}

TEST(ReadE57, MovesOnlyWhereTheRotationIsNone) {
  const E57Sample sample{.columns = cartesianColumns({1}, {2}, {3}),
                         .more = test::e57Pose(0, 0, 0, 0, 10, 20, 30)};
  const Imported<RawPoints> points = importE57(e57File({sample}));
  EXPECT_THAT(points.value.positions, ElementsAre(Eigen::Vector3d(11, 22, 33)));
  EXPECT_THAT(eachInEnglish(points.notes),
              ElementsAre(HasSubstr("the rotation of station 1 is no unit")));
}

TEST(ReadE57, TurnsSphericalPositionsIntoCartesian) {
  const double quarter = std::numbers::pi / 2;
  const E57Sample sample{.columns = {{.name = "sphericalRange", .values = {2, 2, 2}},
                                     {.name = "sphericalAzimuth", .values = {0, quarter, 0}},
                                     {.name = "sphericalElevation", .values = {0, 0, quarter}}}};
  const RawPoints points = importE57(e57File({sample})).value;
  EXPECT_LT((points.positions[0] - Eigen::Vector3d(2, 0, 0)).norm(), 1e-12);
  EXPECT_LT((points.positions[1] - Eigen::Vector3d(0, 2, 0)).norm(), 1e-12);
  EXPECT_LT((points.positions[2] - Eigen::Vector3d(0, 0, 2)).norm(), 1e-12);
}

TEST(ReadE57, LeavesOutPointsWhosePositionIsInvalid) {
  E57Sample sample{.columns = cartesianColumns({1, 2, 3}, {0, 0, 0}, {0, 0, 0})};
  sample.columns.insert(sample.columns.begin(),
                        {"cartesianInvalidState", E57Packing::integer, {0, 2, 1}, 0, 2});
  const Imported<RawPoints> points = importE57(e57File({sample}));
  EXPECT_THAT(points.value.positions, ElementsAre(Eigen::Vector3d(1, 0, 0)));
  EXPECT_THAT(eachInEnglish(points.notes),
              ElementsAre("tree.e57: 2 of 3 points are marked as having no position "
                          "and are left out"));
}

/// Two points of this color, black and the brightest.
E57Sample coloredSample(E57Packing packing, double brightest, std::int64_t maximum) {
  E57Sample sample{.columns = cartesianColumns({1, 2}, {0, 0}, {0, 0})};
  for (const char* name : {"colorRed", "colorGreen", "colorBlue"})
    sample.columns.push_back({name, packing, {0, brightest}, 0, maximum});
  return sample;
}

TEST(ReadE57, ScalesColorsFromTheLimitsOfTheCameraOrElseOfTheFields) {
  const auto colorsOf = [](const E57Sample& sample) {
    return importE57(e57File({sample})).value.colors;
  };
  const auto blackAndWhite = ElementsAre(Color{0, 0, 0}, Color{255, 255, 255});
  EXPECT_THAT(colorsOf(coloredSample(E57Packing::integer, 255, 255)), blackAndWhite);
  EXPECT_THAT(colorsOf(coloredSample(E57Packing::integer, 65535, 65535)), blackAndWhite);
  EXPECT_THAT(colorsOf(coloredSample(E57Packing::integer, 1023, 1023)), blackAndWhite);
  EXPECT_THAT(colorsOf(coloredSample(E57Packing::single, 1, 0)), blackAndWhite);
  EXPECT_THAT(colorsOf(coloredSample(E57Packing::real, 255, 0)), blackAndWhite);
  E57Sample stated = coloredSample(E57Packing::integer, 100, 65535);
  stated.more = "<colorLimits type=\"Structure\">";
  for (const std::string name : {"colorRed", "colorGreen", "colorBlue"})
    stated.more += "<" + name + "Minimum type=\"Integer\"/><" + name +
                   "Maximum type=\"Integer\">200</" + name + "Maximum>";
  stated.more += "</colorLimits>";
  EXPECT_THAT(colorsOf(stated), ElementsAre(Color{0, 0, 0}, Color{128, 128, 128}));
}

TEST(ReadE57, ShowsWhatSomeStationsLack) {
  E57Sample colored = coloredSample(E57Packing::integer, 255, 255);
  E57Sample intense{.columns = cartesianColumns({1, 2}, {0, 0}, {0, 0})};
  intense.columns.push_back({.name = "intensity", .values = {0.5, 7}});
  const Imported<RawPoints> points = importE57(e57File({intense, colored}));
  EXPECT_THAT(points.value.intensities, ElementsAre(0.5F, 7.0F, 0.0F, 0.0F));
  EXPECT_THAT(points.value.colors, ElementsAre(Color{}, Color{}, Color{}, Color{255, 255, 255}));
  EXPECT_THAT(eachInEnglish(points.notes),
              ElementsAre(HasSubstr("2 stations"),
                          "tree.e57: no colors in 1 of 2 stations: points there are black",
                          "tree.e57: no intensities in 1 of 2 stations: those of points there "
                          "are 0"));
}

TEST(ReadE57, PassesOverFieldsItDoesNotKnowAndStationsWithoutPoints) {
  E57Sample sample = plainSample();
  sample.columns.insert(sample.columns.begin() + 1,
                        {"nor:normalX", E57Packing::integer, series(100, -3, 0), -7, 20});
  sample.columns.push_back({.name = "timeStamp", .values = series(100, 0, 1)});
  E57Sample empty{.columns = cartesianColumns({}, {}, {})};
  const Imported<RawPoints> points = importE57(e57File({empty, sample}));
  EXPECT_THAT(points.value.positions, SizeIs(100));
  EXPECT_EQ(points.value.positions[41], Eigen::Vector3d(42, 0, 0));
  EXPECT_THAT(points.notes, IsEmpty());
}

TEST(ReadE57, NamesThePageThatIsDamaged) {
  std::string file = e57File({plainSample()});
  ASSERT_GT(file.size(), 3 * 1024U);
  file[1024 + 100] = static_cast<char>(file[1024 + 100] ^ 1);
  EXPECT_EQ(refusalOfE57(file), "tree.e57, byte 1024: page 2 of " +
                                    std::to_string(file.size() / 1024) +
                                    " does not fit its checksum: the file is damaged, copy or "
                                    "export it again");
}

TEST(ReadE57, RefusesAFileCutShortAnywhere) {
  const std::string file = e57File({plainSample()});
  for (std::size_t size = 0; size < file.size(); size += 97)
    EXPECT_NE(refusalOfE57(file.substr(0, size)), "") << size;
  EXPECT_THAT(refusalOfE57(file.substr(0, 1024)), HasSubstr("cut short"));
}

TEST(ReadE57, NamesWhatIsWrongInTheHeader) {
  const std::string file = e57File({plainSample()});
  EXPECT_THAT(refusalOfE57(""), HasSubstr("does not begin with ASTM-E57"));
  EXPECT_THAT(refusalOfE57("ASTM-E57"), HasSubstr("ends within its header"));
  const auto withByte = [&](std::size_t at, char value) {
    std::string bytes = file;
    bytes[at] = value;
    return test::withChecksums(bytes);
  };
  EXPECT_THAT(refusalOfE57(withByte(8, 2)), HasSubstr("byte 8: is E57 2.0"));
  EXPECT_THAT(refusalOfE57(withByte(41, 8)), HasSubstr("byte 40: has pages of 2048 bytes"));
  EXPECT_THAT(refusalOfE57(withByte(17, 1)), HasSubstr("no whole pages"));
  EXPECT_THAT(refusalOfE57(withByte(30, 1)),
              HasSubstr("says that the XML of 388 bytes starts at byte"));
  EXPECT_THAT(refusalOfE57(withByte(38, 1)), HasSubstr("the XML of"));
}

TEST(ReadE57, NamesTheLineOfTheXmlThatIsWrong) {
  const std::string file = e57File({plainSample()});
  EXPECT_THAT(refusalOfE57(altered(file, "</prototype>", "</prototyp_>")),
              StartsWith("tree.e57, XML, line 10: the XML is broken"));
  EXPECT_THAT(refusalOfE57(altered(file, "<cartesianY", "<cartesianU")),
              StartsWith("tree.e57, XML, line 6: its points have neither cartesianX"));
  EXPECT_THAT(refusalOfE57(altered(file, "recordCount=\"100\"", "recordCount=\"1x0\"")),
              HasSubstr("expected a whole number as recordCount, found '1x0'"));
  EXPECT_THAT(refusalOfE57(altered(file, "cartesianX type=\"Float\"", "cartesianX type=\"Blob\" ")),
              HasSubstr("'cartesianX' is of type 'Blob'"));
}

TEST(ReadE57, RefusesCodecsOfLaterVersions) {
  E57Sample sample = plainSample();
  const auto codec = [](const std::string& name) {
    return "<vectorChild type=\"Structure\"><inputs type=\"Vector\"/><" + name +
           " type=\"Structure\"/></vectorChild>";
  };
  sample.codecs = codec("bitPackCodec");
  EXPECT_EQ(refusalOfE57(e57File({sample})), "");
  sample.codecs = codec("zipCodec");
  EXPECT_THAT(refusalOfE57(e57File({sample})),
              HasSubstr("line 11: the points are packed by 'zipCodec'"));
}

TEST(ReadE57, NamesTheBytesOfASectionOrPacketThatIsDamaged) {
  const std::string file = e57File({plainSample()});
  const auto withByte = [&](std::size_t at, char value) {
    std::string bytes = file;
    bytes[at] = value;
    return refusalOfE57(test::withChecksums(bytes));
  };
  constexpr std::size_t section = 48;
  constexpr std::size_t packet = section + 32; // of an index, 16 bytes long
  EXPECT_THAT(withByte(section, 2), HasSubstr("byte 48: expected a section of points"));
  EXPECT_THAT(withByte(section + 14, 1), HasSubstr("byte 48: a section of points of"));
  EXPECT_THAT(withByte(section + 16, 0), HasSubstr("byte 48: the first packet"));
  EXPECT_THAT(withByte(packet, 3), HasSubstr("byte 80: expected a packet of type 0 to 2"));
  EXPECT_THAT(withByte(packet + 2, 1), HasSubstr("byte 80: expected a packet"));
  EXPECT_THAT(withByte(packet + 16 + 4, 2), HasSubstr("byte 96: a packet of data has 2 streams"));
  EXPECT_THAT(withByte(packet + 16 + 7, 1), HasSubstr("are longer than it is"));
  EXPECT_THAT(withByte(packet + 16 + 6, 8), HasSubstr("93 of 100 points"));
}

TEST(ReadE57, DoesNotTrustThePromisedNumberOfPoints) {
  E57Sample sample = plainSample();
  sample.promised = 1'000'000'000'000;
  EXPECT_THAT(refusalOfE57(e57File({sample})), HasSubstr("promises 1000000000000 points"));
  sample.promised = 101;
  EXPECT_THAT(refusalOfE57(e57File({sample})), HasSubstr("with 100 of 101 points"));
  for (E57Column& column : sample.columns)
    column = {column.name, E57Packing::integer, series(100, 3, 0), 3, 3};
  EXPECT_THAT(importE57(e57File({sample})).value.positions,
              testing::AllOf(SizeIs(101), Each(Eigen::Vector3d(3, 3, 3))));
  sample.promised = 4'000'000'000; // which no byte has to be there for
  EXPECT_THAT(refusalOfE57(e57File({sample})), HasSubstr("as of no scan"));
  sample.promised = 900'000;
  EXPECT_THAT(refusalOfE57(e57File({sample, sample})), HasSubstr("as of no scan"));
}

TEST(ReadE57, ReadsNoSectionForManyScans) {
  const std::string file = e57File({plainSample(), plainSample()});
  const std::string content = e57Content(file);
  const std::size_t second = content.rfind("fileOffset=\"");
  const std::string place = content.substr(second, content.find('"', second + 12) + 1 - second);
  const std::string first = "fileOffset=\"" + std::string(place.size() - 15, '0') + "48\"";
  EXPECT_THAT(refusalOfE57(altered(file, place, first)), "") << "within the size of the file";
  std::string xml = content.substr(content.find("<?xml"));
  xml.resize(xml.rfind('>') + 1);
  const std::size_t scan = xml.find("<vectorChild");
  const std::string one = xml.substr(scan, xml.find("</vectorChild>") + 15 - scan);
  for (int i = 0; i < 20; ++i)
    xml.insert(scan, one);
  const std::size_t start = content.find("<?xml");
  EXPECT_THAT(refusalOfE57(test::e57Pages(content.substr(0, start) + xml, start, xml.size())),
              HasSubstr("the same section of points"));
}

TEST(ReadE57, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  std::istringstream in(test::e57SampleFile());
  EXPECT_THROW((void)readE57(in, "tree.e57", {}, Progress(stop.get_token(), {})), Cancelled);
}

TEST(ReadE57, StopsInTheMidstOfPoints) {
  std::stop_source stop;
  const Progress progress(stop.get_token(), [&](double done, std::string_view) {
    if (done >= 0.3) stop.request_stop();
  });
  std::istringstream in(e57File({plainSample(), plainSample()}));
  EXPECT_THROW((void)readE57(in, "tree.e57", {}, progress), Cancelled);
}

RawPoints sharedPoints(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return readE57(in, path.filename().string()).value;
}

Eigen::AlignedBox3d boundsOf(const RawPoints& points) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& position : points.positions)
    box.extend(position);
  return box;
}

TEST(ReadE57, FindsTheSameBunnyInDoublesAndInScaledIntegers) {
  ESPALIER_SHARED_FILE(doubles, "e57/bunnyDouble.e57");
  ESPALIER_SHARED_FILE(integers, "e57/bunnyInt32.e57");
  const RawPoints exact = sharedPoints(doubles);
  const RawPoints rounded = sharedPoints(integers);
  ASSERT_THAT(exact.positions, SizeIs(30571));
  ASSERT_THAT(rounded.positions, SizeIs(30571));
  for (std::size_t i = 0; i < exact.positions.size(); ++i)
    ASSERT_LE((exact.positions[i] - rounded.positions[i]).cwiseAbs().maxCoeff(), 1e-6) << i;
  // As the XML states them.
  EXPECT_LT((boundsOf(exact).min() - Eigen::Vector3d(-0.094689, 0.040011, -0.061873)).norm(), 1e-9);
  EXPECT_LT((boundsOf(exact).max() - Eigen::Vector3d(0.061009, 0.187321, 0.058799)).norm(), 1e-9);
}

TEST(ReadE57, FindsTheColorsOfACube) {
  ESPALIER_SHARED_FILE(floats, "e57/ColouredCubeFloat.e57");
  const RawPoints cube = sharedPoints(floats);
  ASSERT_THAT(cube.positions, SizeIs(7680));
  ASSERT_THAT(cube.colors, SizeIs(7680));
  EXPECT_EQ(cube.colors[0], (Color{0, 0, 255}));
  EXPECT_EQ(boundsOf(cube).min(), Eigen::Vector3d(-0.5, -0.5, -0.5));
  EXPECT_EQ(boundsOf(cube).max(), Eigen::Vector3d(0.5, 0.5, 0.5));
}

TEST(ReadE57, FindsColorsOf16BitsAmongFieldsOfAnExtension) {
  ESPALIER_SHARED_FILE(words, "e57/ColourRepresentation.e57");
  const RawPoints points = sharedPoints(words);
  ASSERT_THAT(points.positions, SizeIs(153));
  ASSERT_THAT(points.colors, SizeIs(153));
  EXPECT_EQ(points.colors[0], (Color{0, 0, 255}));
  EXPECT_LT((boundsOf(points).sizes() - Eigen::Vector3d(1, 1, 1)).norm(), 1e-9);
}

TEST(ReadE57, RefusesBrokenAndEmptyFilesInOneLine) {
  ESPALIER_SHARED_FILE(folder, "e57");
  const auto refusal = [&](const char* name) {
    const std::string said = test::errorOf([&] { return readPoints(folder / name); });
    return said.substr(folder.string().size() + 1);
  };
  EXPECT_THAT(refusal("bad-crc.e57"), StartsWith("bad-crc.e57, byte 0: page 1 of 1 does not fit"));
  EXPECT_EQ(refusal("empty.e57"), "empty.e57: holds no points: export it again");
  EXPECT_EQ(refusal("ZeroPoints.e57"), "ZeroPoints.e57: holds no points: export it again");
  EXPECT_EQ(refusal("InvalidCVHeader.e57"),
            "InvalidCVHeader.e57: holds no points: export it again");
}

} // namespace
} // namespace espalier
