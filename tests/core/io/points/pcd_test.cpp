#include "core/io/points/lzf.h"
#include "core/io/points/pcd.h"
#include "tests/core/io/samples.h"

#include <algorithm>
#include <gmock/gmock.h>
#include <sstream>

namespace espalier {
namespace {

using test::pcdFile;
using test::PcdKind;
using testing::ElementsAre;
using testing::HasSubstr;

Imported<RawPoints> importPcd(const std::string& bytes) {
  std::istringstream in(bytes);
  return readPcd(in, "tree.pcd");
}

std::string refusalOfPcd(const std::string& bytes) {
  return test::errorOf([&] { return importPcd(bytes); });
}

/// The sample of text with `line` in the place of the header line of that keyword.
std::string withLine(const std::string& keyword, const std::string& line) {
  std::string bytes = pcdFile(PcdKind::ascii);
  const std::size_t start = bytes.find("\n" + keyword + " ") + 1;
  return bytes.replace(start, bytes.find('\n', start) - start, line);
}

class ReadPcdOfAnyKind : public testing::TestWithParam<PcdKind> {};

TEST_P(ReadPcdOfAnyKind, FindsPositionsIntensitiesAndPackedColors) {
  const std::string bytes = pcdFile(GetParam());
  EXPECT_TRUE(isPcd(bytes));
  const RawPoints points = importPcd(bytes).value;
  EXPECT_THAT(points.positions, ElementsAre(Eigen::Vector3d(1, 2.5, 0), Eigen::Vector3d(2, 2.5, -1),
                                            Eigen::Vector3d(3, 2.5, -2)));
  EXPECT_THAT(points.colors,
              ElementsAre(Color{200, 100, 10}, Color{200, 100, 11}, Color{200, 100, 12}));
  EXPECT_THAT(points.intensities, ElementsAre(0.0F, 7.0F, 14.0F));
}

TEST_P(ReadPcdOfAnyKind, RefusesAFileCutShort) {
  const std::string bytes = pcdFile(GetParam());
  const std::size_t data = bytes.find('\n', bytes.find("DATA")) + 1;
  for (std::size_t size = data; size + 4 < bytes.size(); ++size)
    EXPECT_NE(refusalOfPcd(bytes.substr(0, size)), "") << size;
}

TEST_P(ReadPcdOfAnyKind, DoesNotTrustItsHeader) {
  std::string bytes = pcdFile(GetParam());
  bytes.replace(bytes.find("POINTS 3"), 8, "POINTS 1000000000000");
  EXPECT_THAT(refusalOfPcd(bytes), HasSubstr("promises 1000000000000 points"));
}

INSTANTIATE_TEST_SUITE_P(All, ReadPcdOfAnyKind,
                         testing::Values(PcdKind::ascii, PcdKind::binary, PcdKind::compressed));

TEST(ReadPcd, NamesTheLineThatIsWrong) {
  EXPECT_THAT(refusalOfPcd(withLine("SIZE", "SIZE 4 4 4")), HasSubstr("line 4: expected 6 values"));
  EXPECT_THAT(refusalOfPcd(withLine("TYPE", "TYPE F F F F F F")),
              HasSubstr("line 5: a field of type"));
  EXPECT_THAT(refusalOfPcd(withLine("COUNT", "COUNT 1 1 1 x 1 1")),
              HasSubstr("line 6: expected a whole"));
  EXPECT_THAT(refusalOfPcd(withLine("FIELDS", "FIELDS x y w normal rgb i")),
              HasSubstr("no field 'z'"));
  EXPECT_THAT(refusalOfPcd(withLine("DATA", "DATA hex")), HasSubstr("line 11: data of kind 'hex'"));
  EXPECT_THAT(refusalOfPcd("# .PCD v0.7\nVERSION 0.7\n"), HasSubstr("no line DATA"));
  std::string bytes = pcdFile(PcdKind::ascii);
  bytes.replace(bytes.find("\n2 2.5"), 6, "\n2 two");
  EXPECT_THAT(refusalOfPcd(bytes), HasSubstr("line 13: expected a number as value 2, found 'two'"));
}

TEST(ReadPcd, CountsByWidthAndHeightIfPointsAreNotGiven) {
  EXPECT_EQ(importPcd(withLine("POINTS", "")).value.positions.size(), 3U);
}

TEST(UnpackedLzf, RepeatsWhatItRefersTo) {
  using namespace std::string_literals;
  EXPECT_EQ(unpackedLzf("\x02"s + "abc", 3), "abc");
  EXPECT_EQ(unpackedLzf("\x00"s + "a" + "\x20\x00"s, 4), "aaaa");
  EXPECT_EQ(unpackedLzf("\x00"s + "a" + "\xe0\x05\x00"s, 15), std::string(15, 'a'));
}

TEST(UnpackedLzf, RefusesDamagedData) {
  using namespace std::string_literals;
  EXPECT_EQ(unpackedLzf("\x05"s + "abc", 6), std::nullopt) << "ends too early";
  EXPECT_EQ(unpackedLzf("\x00"s + "a" + "\x20\x01"s, 4), std::nullopt) << "refers before the start";
  EXPECT_EQ(unpackedLzf("\x02"s + "abc", 4), std::nullopt) << "too few";
  EXPECT_EQ(unpackedLzf("\x02"s + "abc", 2), std::nullopt) << "too many";
  EXPECT_EQ(unpackedLzf("\x02"s + "abc", std::size_t{1} << 40), std::nullopt);
  EXPECT_EQ(unpackedLzf("\xe0"s, 9), std::nullopt) << "a copy without its distance";
  EXPECT_EQ(unpackedLzf("", 1), std::nullopt);
  EXPECT_EQ(unpackedLzf("\x00"s + "a", 0), std::nullopt);
  EXPECT_EQ(unpackedLzf("", 0), "");
}

/// A compressed file of points without coordinates other than 0 in one-byte fields.
std::string packedZeros(std::uint32_t points) {
  std::string packed;
  appendValue(packed, std::uint8_t{0}); // one byte as it is, and then copies of 264
  appendValue(packed, std::uint8_t{0});
  const std::uint32_t size = 3 * points;
  for (std::uint32_t at = 1; at < size;) {
    const std::uint32_t length = std::min<std::uint32_t>(264, size - at);
    if (length < 9) {
      packed += '\0';
      packed += '\0';
      ++at;
      continue;
    }
    packed += '\xe0';
    packed += static_cast<char>(length - 9);
    packed += '\0';
    at += length;
  }
  std::string bytes = "VERSION 0.7\nFIELDS x y z\nSIZE 1 1 1\nTYPE I I I\nCOUNT 1 1 1\nWIDTH " +
                      std::to_string(points) + "\nHEIGHT 1\nPOINTS " + std::to_string(points) +
                      "\nDATA binary_compressed\n";
  appendValue(bytes, static_cast<std::uint32_t>(packed.size()));
  appendValue(bytes, size);
  return bytes + packed;
}

TEST(ReadPcd, DoesNotUnpackWhatNoScanFills) {
  EXPECT_EQ(importPcd(packedZeros(1000)).value.positions.size(), 1000U);
  EXPECT_THAT(refusalOfPcd(packedZeros(90'000'000)),
              HasSubstr("would unpack to 270000000 bytes of 90000000 points, as of no scan"));
}

} // namespace
} // namespace espalier
