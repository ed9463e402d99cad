#include "ui/view/point_colors.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace espalier {
namespace {

constexpr Color plainColor{1, 2, 3};

/// Points 0 to 100 high, as bright as they are high but for one that is very bright.
PointCloud column() {
  RawPoints raw;
  for (int z = 0; z <= 100; ++z) {
    raw.positions.emplace_back(0, 0, 500'000 + z);
    raw.intensities.push_back(z == 50 ? 1e6F : static_cast<float>(z));
    raw.colors.push_back({0, 0, static_cast<std::uint8_t>(z)});
  }
  return PointCloud(std::move(raw));
}

std::vector<Color> allOf(const PointColors& colors, const PointCloud& cloud) {
  std::vector<Color> all;
  for (Eigen::Index point = 0; point < cloud.size(); ++point)
    all.push_back(colors[point]);
  return all;
}

TEST(PointColors, RunThroughTheMapWithHeight) {
  const PointCloud cloud = column();
  const auto scale = pointLegend(cloud, PointColor::height);
  ASSERT_TRUE(scale);
  EXPECT_DOUBLE_EQ(scale->from, 500'000);
  EXPECT_DOUBLE_EQ(scale->to, 500'100);
  const auto colors = allOf(PointColors(cloud, PointColor::height, scale, true, plainColor), cloud);
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const double height = cloud.position(static_cast<Eigen::Index>(i)).z() - 500'000;
    const Color expected = colorOf(ColorMap::viridis, height / 100, true);
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_NEAR(colors[i][c], expected[c], 3) << height;
  }
}

TEST(PointColors, RunAlongTheAxisThatIsUp) {
  RawPoints raw;
  for (int y = 0; y <= 10; ++y)
    raw.positions.emplace_back(0, 700 + y, 3);
  const PointCloud cloud(std::move(raw));
  EXPECT_FALSE(pointLegend(cloud, PointColor::height)) << "all at one z";
  const auto scale = pointLegend(cloud, PointColor::height, UpAxis::y);
  ASSERT_TRUE(scale);
  EXPECT_EQ(scale->title, "Height y");
  EXPECT_DOUBLE_EQ(scale->from, 700);
  EXPECT_DOUBLE_EQ(scale->to, 710);
  const auto colors =
      allOf(PointColors(cloud, PointColor::height, scale, true, plainColor, UpAxis::y), cloud);
  EXPECT_NE(colors.front(), colors.back());
}

TEST(PointColors, AreNotSpoiledByOneBrightPoint) {
  const auto scale = pointLegend(column(), PointColor::intensity);
  ASSERT_TRUE(scale);
  EXPECT_NEAR(scale->from, 2, 1);
  EXPECT_NEAR(scale->to, 98, 2);
}

TEST(PointColors, SpanThePointsInUse) {
  const PointCloud cloud = column();
  std::vector<Eigen::Index> upper;
  for (Eigen::Index point = 0; point < cloud.size(); ++point)
    if (cloud.position(point).z() > 500'040) upper.push_back(point);
  const PointSet aside = PointSet::of(upper);
  const auto heights = pointLegend(cloud, PointColor::height, UpAxis::z, aside);
  ASSERT_TRUE(heights);
  EXPECT_DOUBLE_EQ(heights->from, 500'000);
  EXPECT_DOUBLE_EQ(heights->to, 500'040);
  const auto intensities = pointLegend(cloud, PointColor::intensity, UpAxis::z, aside);
  ASSERT_TRUE(intensities);
  EXPECT_LE(intensities->to, 40);
  const PointSet all = PointSet::firstOf(cloud.size());
  for (const PointColor by : {PointColor::height, PointColor::intensity})
    EXPECT_FALSE(pointLegend(cloud, by, UpAxis::z, all)) << "nothing is in use";
}

TEST(PointColors, AreNotSpoiledByAPointFarAway) {
  RawPoints raw;
  for (int z = 0; z <= 100; ++z)
    raw.positions.emplace_back(0, 0, z);
  raw.positions.emplace_back(0, 0, -5e6);
  const auto scale = pointLegend(PointCloud(raw), PointColor::height);
  ASSERT_TRUE(scale);
  EXPECT_DOUBLE_EQ(scale->from, 0);
  EXPECT_DOUBLE_EQ(scale->to, 100);
  EXPECT_DOUBLE_EQ(scale->histogram.range.from, 0) << "nor is how often heights are found";
}

TEST(PointColors, AreThoseOfTheScannerOnRequest) {
  const PointCloud cloud = column();
  EXPECT_EQ(allOf(PointColors(cloud, PointColor::rgb, std::nullopt, true, plainColor), cloud),
            cloud.colors());
}

TEST(PointColors, ArePlainForWantOfWhatTheyStandFor) {
  RawPoints raw;
  raw.positions.assign(5, {1, 2, 3});
  const PointCloud cloud(std::move(raw));
  for (const PointColor by :
       {PointColor::uniform, PointColor::height, PointColor::intensity, PointColor::rgb}) {
    EXPECT_FALSE(pointLegend(cloud, by)); // all as high as each other
    EXPECT_THAT(allOf(PointColors(cloud, by, std::nullopt, false, plainColor), cloud),
                testing::Each(plainColor));
  }
}

} // namespace
} // namespace espalier
