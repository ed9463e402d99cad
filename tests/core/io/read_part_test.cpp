#include "core/io/formats.h"
#include "core/io/glance.h"
#include "tests/core/io/samples.h"
#include "tests/support/shared_data.h"

#include <fstream>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::EndsWith;
using testing::HasSubstr;

/// 1000 points in a row, from 0 0 0 to 999 0 10, with two more numbers each.
std::filesystem::path rowOfPoints(const char* name = "row.xyz") {
  const std::filesystem::path path = test::freshFolder() / name;
  std::ofstream out(path);
  for (int i = 0; i < 1000; ++i)
    out << i << " 0 " << 0.01 * i << ' ' << 300 + i << " 0 \n";
  return path;
}

Eigen::AlignedBox3d boxFrom(double least, double most) {
  return {Eigen::Vector3d(least, -1, -1), Eigen::Vector3d(most, 1, 100)};
}

TEST(ReadPart, SaysHowManyOfHowManyPointsItTook) {
  const auto path = rowOfPoints();
  const ImportedCloud sample = readPoints(path, ReadOptions{.most = 100});
  EXPECT_EQ(sample.value.size(), 100);
  EXPECT_EQ(sample.listed, 1000U);
  EXPECT_THAT(
      eachInEnglish(sample.notes),
      testing::Contains(EndsWith("/row.xyz: 100 of 1000 points are read, a sample of all")));
  EXPECT_THAT(
      eachInEnglish(readPoints(path, ReadOptions{.box = boxFrom(100, 199)}).notes),
      testing::Contains(EndsWith("/row.xyz: 100 of 1000 points are read, those in the box")));
  EXPECT_THAT(
      eachInEnglish(readPoints(path, ReadOptions{.most = 10, .box = boxFrom(100, 199)}).notes),
      testing::Contains(
          EndsWith("/row.xyz: 10 of 1000 points are read, a sample of those in the box")));
  const ImportedCloud whole = readPoints(path, ReadOptions{.most = 1000});
  EXPECT_EQ(whole.value.size(), 1000);
  EXPECT_THAT(eachInEnglish(whole.notes), testing::Each(testing::Not(HasSubstr("are read"))));
}

TEST(ReadPart, RefusesABoxOutsideOfTheScan) {
  const auto path = rowOfPoints();
  EXPECT_THAT(
      test::errorOf([&] { return readPoints(path, ReadOptions{.box = boxFrom(2000, 3000)}); }),
      EndsWith(
          "/row.xyz: none of its 1000 points lies in the box from 2000, -1, -1 to 3000, 1, 100: "
          "they lie from 0, 0, 0 to 999, 0, 9.99"));
}

TEST(ReadPart, TakesColumnsAsTheyAreNamed) {
  const auto path = rowOfPoints();
  using enum PointField;
  const std::vector<PointField> columns = {z, y, x, intensity, none};
  const ImportedCloud cloud = readPoints(path, ReadOptions{.columns = columns});
  EXPECT_EQ(cloud.value.bounds().max().z(), 999);
  EXPECT_EQ(cloud.value.intensities().size(), 1000U);
  EXPECT_THAT(eachInEnglish(cloud.notes), testing::Each(testing::Not(HasSubstr("left out"))));
  const PointGlance glance = glanceAt(path, columns);
  EXPECT_EQ(glance.columns[0].name, "z");
  EXPECT_EQ(glance.columns[3].name, "intensity");
  EXPECT_FALSE(glance.columns[4].isTaken);
}

TEST(ReadPart, RefusesColumnsThatAreNotThere) {
  const auto path = rowOfPoints();
  using enum PointField;
  EXPECT_THAT(
      test::errorOf([&] {
        return readPoints(path, ReadOptions{.columns = {x, y, z}});
      }),
      EndsWith(
          "/row.xyz: 3 columns are named, but its first line of points has 5: name each, with - "
          "for those to leave out"));
}

TEST(ReadPart, RefusesColumnsOfAFormatThatNamesItsOwn) {
  const std::filesystem::path path = test::freshFolder() / "tree.las";
  std::ofstream(path, std::ios::binary) << test::lasFile({});
  using enum PointField;
  const std::string refusal = path.string() +
                              ": is LAS, which says itself what its columns hold: name "
                              "columns of text files alone";
  EXPECT_EQ(test::errorOf([&] {
              return readPoints(path, ReadOptions{.columns = {x, y, z}});
            }),
            refusal);
  EXPECT_EQ(test::errorOf([&] { return glanceAt(path, {x, y, z}); }), refusal);
}

} // namespace
} // namespace espalier
