#include "core/base/shown_message.h"
#include "core/io/points/las.h"
#include "tests/core/io/samples.h"

#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

using test::lasFile;
using testing::HasSubstr;

Imported<RawPoints> importLas(const std::string& bytes) {
  std::istringstream in(bytes);
  return readLas(in, "tree.las");
}

std::string refusalOfLas(const std::string& bytes) {
  return test::errorOf([&] { return importLas(bytes); });
}

struct Layout {
  int minorVersion;
  int format;
};

void PrintTo(const Layout& layout, std::ostream* out) {
  *out << "LAS 1." << layout.minorVersion << ", format " << layout.format;
}

std::vector<Layout> allLayouts() {
  std::vector<Layout> layouts;
  for (const auto& [minor, last] : {std::pair{0, 1}, {1, 1}, {2, 3}, {3, 5}, {4, 10}})
    for (int format = 0; format <= last; ++format)
      layouts.push_back({minor, format});
  return layouts;
}

class ReadLasOfAnyKind : public testing::TestWithParam<Layout> {};

TEST_P(ReadLasOfAnyKind, FindsPositionsIntensitiesAndColors) {
  const auto [minor, format] = GetParam();
  const RawPoints points =
      importLas(lasFile({.minorVersion = minor, .format = format, .extraBytes = 5})).value;
  ASSERT_EQ(points.positions.size(), 3U);
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const Eigen::Vector3d expected(500001 + 0.001 * i, 4000002 + 0.002 * i, 100 + 0.003 * i);
    EXPECT_LT((points.positions[at] - expected).norm(), 1e-8);
    EXPECT_EQ(points.intensities.at(at), static_cast<float>(100 + i));
  }
  const bool hasColors =
      format == 2 || format == 3 || format == 5 || format == 7 || format == 8 || format == 10;
  ASSERT_EQ(points.colors.size(), hasColors ? 3U : 0U);
  if (hasColors) {
    EXPECT_EQ(points.colors[2], (Color{12, 22, 32}));
  }
}

TEST_P(ReadLasOfAnyKind, LeavesOutWithheldPoints) {
  const auto [minor, format] = GetParam();
  const Imported<RawPoints> points =
      importLas(lasFile({.minorVersion = minor, .format = format, .withheld = 1}));
  if (minor == 0) { // the bit was a part of the class then
    EXPECT_EQ(points.value.positions.size(), 3U);
    return;
  }
  EXPECT_EQ(points.value.positions.size(), 2U);
  EXPECT_THAT(eachInEnglish(points.notes),
              testing::ElementsAre("tree.las: 1 of 3 points are flagged as withheld "
                                   "and are left out"));
}

TEST_P(ReadLasOfAnyKind, RefusesAFileCutShort) {
  const auto [minor, format] = GetParam();
  const std::string bytes = lasFile({.minorVersion = minor, .format = format});
  EXPECT_THAT(refusalOfLas(bytes.substr(0, bytes.size() - 1)), HasSubstr("cut short"));
  EXPECT_THAT(refusalOfLas(bytes.substr(0, 230)), HasSubstr("cut short"));
  EXPECT_THAT(refusalOfLas(bytes.substr(0, 120)), HasSubstr("cut short"));
}

INSTANTIATE_TEST_SUITE_P(All, ReadLasOfAnyKind, testing::ValuesIn(allLayouts()));

TEST(ReadLas, TakesColorsOfEightBitsAsTheyAre) {
  EXPECT_EQ(importLas(lasFile({.format = 2, .colorUnit = 1})).value.colors[1], (Color{11, 21, 31}));
}

TEST(ReadLas, TakesColorsThatAreAllBlackAsNone) {
  EXPECT_TRUE(importLas(lasFile({.format = 2, .colorUnit = 0})).value.colors.empty());
}

TEST(ReadLas, RefusesCompressedFiles) {
  for (const std::uint8_t bits : {std::uint8_t{0x80}, std::uint8_t{0x40}}) {
    const std::string bytes = lasFile({.formatBits = bits});
    EXPECT_TRUE(isLaz(bytes));
    EXPECT_THAT(refusalOfLas(bytes), HasSubstr("is compressed (LAZ)"));
  }
  EXPECT_FALSE(isLaz(lasFile({})));
}

TEST(ReadLas, DoesNotTrustItsHeader) {
  EXPECT_THAT(
      refusalOfLas(lasFile({.minorVersion = 4, .format = 6, .promised = 1'000'000'000'000})),
      HasSubstr("promises 1000000000000 points"));
  EXPECT_THAT(refusalOfLas(lasFile({.promised = 4'000'000'000})), HasSubstr("promises 4000000000"));
  std::string bytes = lasFile({});
  bytes[105] = 19; // bytes of a record: one less than the format has
  EXPECT_THAT(refusalOfLas(bytes), HasSubstr("fewer than the 20"));
  bytes = lasFile({});
  bytes[104] = 11;
  EXPECT_THAT(refusalOfLas(bytes), HasSubstr("format 11"));
  bytes = lasFile({});
  bytes[25] = 5;
  EXPECT_THAT(refusalOfLas(bytes), HasSubstr("LAS 1.5"));
  EXPECT_THAT(refusalOfLas("LASX"), HasSubstr("no LAS file"));
  EXPECT_THAT(refusalOfLas(""), HasSubstr("no LAS file"));
}

TEST(ReadLas, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  std::istringstream in(lasFile({}));
  EXPECT_THROW((void)readLas(in, "tree.las", {}, Progress(stop.get_token(), {})), Cancelled);
}

} // namespace
} // namespace espalier
