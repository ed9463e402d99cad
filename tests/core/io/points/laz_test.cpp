#include "core/base/parallel.h"
#include "core/base/shown_message.h"
#include "core/io/points/las.h"
#include "core/io/points/laz.h"
#include "tests/core/io/points/laz_writer.h"
#include "tests/core/io/samples.h"
#include "tests/support/shared_data.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <gmock/gmock.h>
#include <iterator>
#include <sstream>
#include <tuple>

namespace espalier {
namespace {

using test::lasFile;
using test::lazFile;
using testing::HasSubstr;

Imported<RawPoints> importLaz(const std::string& bytes) {
  std::istringstream in(bytes);
  return readLaz(in, "tree.laz");
}

Imported<RawPoints> importUnpacked(const std::string& bytes) {
  std::istringstream in(bytes);
  return readLas(in, "tree.laz");
}

std::string refusalOfLaz(const std::string& bytes) {
  return test::errorOf([&] { return importLaz(bytes); });
}

std::string fileBytes(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void expectSame(const Imported<RawPoints>& left, const Imported<RawPoints>& right) {
  EXPECT_EQ(left.value.positions, right.value.positions);
  EXPECT_EQ(left.value.intensities, right.value.intensities);
  EXPECT_EQ(left.value.colors, right.value.colors);
  EXPECT_EQ(left.notes, right.notes);
}

/// A noisy file of 500 points.
std::string noisyLas(int format, std::size_t extraBytes = 0) {
  return test::withNoise(lasFile({.minorVersion = format < 6 ? 2 : 4,
                                  .format = format,
                                  .points = 500,
                                  .extraBytes = extraBytes}),
                         static_cast<std::uint64_t>(format) + 1);
}

struct LazKind {
  int format;
  int version;
};

void PrintTo(const LazKind& kind, std::ostream* out) {
  *out << "format " << kind.format << ", version " << kind.version;
}

class ReadLazOfAnyKind : public testing::TestWithParam<LazKind> {};

TEST_P(ReadLazOfAnyKind, GivesThePointsOfTheFileUnpacked) {
  const auto [format, version] = GetParam();
  for (const std::size_t extraBytes : {0U, 5U}) {
    const std::string las = noisyLas(format, extraBytes);
    const Imported<RawPoints> expected = importUnpacked(las);
    expectSame(importLaz(lazFile(las, {.version = version})), expected);
    expectSame(importLaz(lazFile(las, {.version = version, .chunkSize = 499})), expected);
    expectSame(importLaz(lazFile(las, {.version = version, .chunkSize = 1})), expected);
    expectSame(importLaz(lazFile(las, {.version = version, .hasTableAtEnd = true})), expected);
    expectSame(importLaz(lazFile(las, {.version = version, .hasChunksOfAnySize = true})), expected);
    if (format < 6)
      expectSame(importLaz(lazFile(las, {.version = version, .chunkSize = 0})), expected);
  }
}

TEST_P(ReadLazOfAnyKind, RefusesAFileCutShort) {
  const auto [format, version] = GetParam();
  const std::string bytes = lazFile(noisyLas(format), {.version = version});
  for (std::size_t size = 0; size < bytes.size(); size += 97)
    EXPECT_NE(refusalOfLaz(bytes.substr(0, size)), "") << size;
}

INSTANTIATE_TEST_SUITE_P(All, ReadLazOfAnyKind,
                         testing::Values(LazKind{0, 1}, LazKind{0, 2}, LazKind{1, 2}, LazKind{2, 2},
                                         LazKind{3, 2}, LazKind{6, 3}, LazKind{6, 4}, LazKind{7, 3},
                                         LazKind{7, 4}, LazKind{8, 3}, LazKind{8, 4}));

TEST(ReadLaz, LeavesOutWithheldPoints) {
  for (const int format : {3, 7}) {
    const Imported<RawPoints> points = importLaz(
        lazFile(lasFile({.minorVersion = format < 6 ? 2 : 4, .format = format, .withheld = 1})));
    EXPECT_EQ(points.value.positions.size(), 2U);
    EXPECT_THAT(eachInEnglish(points.notes),
                testing::ElementsAre("tree.laz: 1 of 3 points are flagged as "
                                     "withheld and are left out"));
  }
}

TEST(ReadLaz, ReadsAFileWithoutPoints) {
  EXPECT_TRUE(importLaz(lazFile(lasFile({.points = 0}))).value.positions.empty());
}

TEST(ReadLaz, GivesTheSameOnAnyNumberOfThreads) {
  const std::string bytes = lazFile(noisyLas(7), {.chunkSize = 10});
  const ThreadLimit one(1);
  const Imported<RawPoints> alone = importLaz(bytes);
  const ThreadLimit two(2);
  expectSame(importLaz(bytes), alone);
}

TEST(ReadLaz, StopsWhenAsked) {
  for (const std::uint32_t chunkSize : {0U, 50U}) {
    const std::string bytes = lazFile(noisyLas(3), {.chunkSize = chunkSize});
    std::stop_source stop;
    const auto stopInTheMiddle = [&](double fraction, std::string_view) {
      if (fraction >= 0.1) stop.request_stop();
    };
    std::istringstream in(bytes);
    EXPECT_THROW((void)readLaz(in, "tree.laz", {}, Progress(stop.get_token(), stopInTheMiddle)),
                 Cancelled);
  }
}

TEST(ReadLaz, KnowsItsFilesByTheirHeader) {
  EXPECT_TRUE(isLaz(lazFile(lasFile({}))));
  EXPECT_FALSE(isLaz(lasFile({})));
  EXPECT_THAT(refusalOfLaz(lasFile({})), HasSubstr("is LAS, not compressed"));
  EXPECT_THAT(refusalOfLaz("LASX"), HasSubstr("no LAS file"));
}

TEST(ReadLaz, RefusesAHeaderWithoutTheRecordOfLaszip) {
  EXPECT_EQ(refusalOfLaz(lasFile({.formatBits = 0x80})),
            "tree.laz: has no record of LASzip on how its points are compressed: the file is cut "
            "short or damaged, copy or export it again");
}

/// A file of format 3 with `value` in the word at `place` of the record of LASzip.
std::string withWord(std::size_t place, std::uint16_t value) {
  std::string bytes = lazFile(noisyLas(3));
  const std::size_t recordStart = 227 + 54;
  setValueAt(bytes.data() + recordStart + place, value);
  return bytes;
}

TEST(ReadLaz, RefusesFormsThatItDoesNotKnowAndSaysHowToUnpack) {
  EXPECT_EQ(refusalOfLaz(withWord(0, 4)),
            "tree.laz: is compressed by a method of number 4, and 1 to 3 can be read: unpack it to "
            "LAS, as by 'laszip -i tree.laz -o unpacked.las'");
  EXPECT_THAT(refusalOfLaz(withWord(2, 1)), HasSubstr("by a coder of number 1"));
  constexpr std::size_t items = 34;
  EXPECT_THAT(refusalOfLaz(withWord(items + 4, 6)), HasSubstr("(item 6) that are compressed in "
                                                              "version 6"));
  EXPECT_THAT(refusalOfLaz(withWord(items + 10, 1)), HasSubstr("(item 7)"));
  EXPECT_THAT(refusalOfLaz(withWord(items, 22)), HasSubstr("of what its points consist"));
  EXPECT_THAT(refusalOfLaz(withWord(items + 2, 21)), HasSubstr("of what its points consist"));
  EXPECT_THAT(refusalOfLaz(withWord(items - 2, 2)), HasSubstr("of what its points consist"));
  EXPECT_THAT(refusalOfLaz(withWord(items - 2, 200)), HasSubstr("ends within its record"));
  EXPECT_THAT(refusalOfLaz(withWord(0, 3)), HasSubstr("which is for other formats"));
}

TEST(ReadLaz, DoesNotTrustCountsAndOffsets) {
  std::string bytes = lazFile(noisyLas(3));
  setValueAt(bytes.data() + 107, std::uint32_t{4'000'000'000}); // points
  EXPECT_THAT(refusalOfLaz(bytes), HasSubstr("promises 4000000000 points"));
  setValueAt(bytes.data() + 107, std::uint32_t{551}); // one more than 11 chunks of 50
  EXPECT_THAT(refusalOfLaz(bytes), HasSubstr("does not fit its 551 points"));
  setValueAt(bytes.data() + 107, std::uint32_t{500});
  EXPECT_EQ(refusalOfLaz(bytes), "");
  const auto start = valueAt<std::uint32_t>(bytes.data() + 96);
  for (const std::uint64_t table : {0UL, 1UL << 63, bytes.size() - 1, ~0UL}) {
    setValueAt(bytes.data() + start, table);
    EXPECT_THAT(refusalOfLaz(bytes), HasSubstr("has no table of its chunks")) << table;
  }
}

TEST(ReadLaz, RefusesChunksThatEndTooEarly) {
  const std::string las = noisyLas(0);
  std::string bytes = lazFile(las, {.chunkSize = 0}); // ends with the points
  bytes.pop_back();
  EXPECT_THAT(refusalOfLaz(bytes), HasSubstr("cannot be unpacked: the file is damaged"));
}

class LazOfOthers : public testing::TestWithParam<const char*> {};

TEST_P(LazOfOthers, HasThePointsOfItsTwin) {
  const std::string name = std::string("laz/") + GetParam();
  ESPALIER_SHARED_FILE(packed, name + ".laz");
  ESPALIER_SHARED_FILE(plain, name + ".las");
  expectSame(importLaz(fileBytes(packed)), importUnpacked(fileBytes(plain)));
}

INSTANTIATE_TEST_SUITE_P(All, LazOfOthers,
                         testing::Values("point10", "point-time", "point-color", "point-time-color",
                                         "extra-bytes", "1815", "point-version-1-point-wise",
                                         "no-points-1.3"));

TEST(LazOfOthersOf14, HasThePointsOfAnOlderFile) {
  ESPALIER_SHARED_FILE(packed, "laz/point-time-1.4.laz");
  ESPALIER_SHARED_FILE(plain, "laz/point-time.las");
  expectSame(importLaz(fileBytes(packed)), importUnpacked(fileBytes(plain)));
}

/// With coordinates in hundredths, as both files have them, whatever their offsets.
using SortablePoint = std::tuple<long, long, long, float, Color>;

std::vector<SortablePoint> sortedPoints(const RawPoints& points) {
  std::vector<SortablePoint> sorted;
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    const Eigen::Vector3d at = 100 * points.positions[i];
    sorted.emplace_back(std::lround(at.x()), std::lround(at.y()), std::lround(at.z()),
                        points.intensities[i], points.colors[i]);
  }
  std::ranges::sort(sorted);
  return sorted;
}

// The octree of a COPC file has the points of the file that it was made from, in another order.
TEST(ReadCopc, FindsAllPointsWithTheirColors) {
  ESPALIER_SHARED_FILE(copc, "laz/color.copc.laz");
  ESPALIER_SHARED_FILE(plain, "laz/extra-bytes.las");
  const RawPoints points = importLaz(fileBytes(copc)).value;
  ASSERT_EQ(points.positions.size(), 1065U);
  EXPECT_EQ(sortedPoints(points), sortedPoints(importUnpacked(fileBytes(plain)).value));
}

TEST(ReadCopc, FindsAllPointsWithinTheBoundsOfTheHeader) {
  ESPALIER_SHARED_FILE(copc, "laz/lone-star.copc.laz");
  const std::string bytes = fileBytes(copc);
  const RawPoints points = importLaz(bytes).value;
  ASSERT_EQ(points.positions.size(), 518862U);
  Eigen::Vector3d least = points.positions[0];
  Eigen::Vector3d most = least;
  for (const Eigen::Vector3d& position : points.positions) {
    least = least.cwiseMin(position);
    most = most.cwiseMax(position);
  }
  for (int axis = 0; axis < 3; ++axis) { // x, y, z: largest and smallest
    EXPECT_NEAR(most[axis], valueAt<double>(bytes.data() + 179 + 16 * axis), 1e-3);
    EXPECT_NEAR(least[axis], valueAt<double>(bytes.data() + 187 + 16 * axis), 1e-3);
  }
}

TEST(BrokenLazOfOthers, IsRefusedInOneLine) {
  for (const char* name : {"coder", "compressor", "size", "type", "version"}) {
    ESPALIER_SHARED_FILE(broken, "laz/broken_" + std::string(name) + ".laz");
    const std::string refusal = refusalOfLaz(fileBytes(broken));
    EXPECT_THAT(refusal, testing::StartsWith("tree.laz: ")) << name;
    EXPECT_THAT(refusal, testing::Not(HasSubstr("\n"))) << name;
  }
}

} // namespace
} // namespace espalier
