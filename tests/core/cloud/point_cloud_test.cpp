#include "core/base/random.h"
#include "core/cloud/point_cloud.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace espalier {
namespace {

RawPoints randomPoints(int count, const Eigen::Vector3d& center) {
  Random random(1);
  RawPoints raw;
  for (int i = 0; i < count; ++i) {
    raw.positions.emplace_back(center + 30 * random.direction());
    raw.colors.push_back({static_cast<std::uint8_t>(i % 256), 7, 9});
    raw.intensities.push_back(static_cast<float>(i));
  }
  return raw;
}

TEST(PointCloud, KeepsAMillimeterOfLargeCoordinates) {
  const RawPoints raw = randomPoints(2000, {455123.4567, 5412987.6543, 312.987}); // UTM, meters
  const PointCloud cloud(raw);
  for (Eigen::Index i = 0; i < cloud.size(); ++i)
    EXPECT_LT(
        (cloud.position(i) - raw.positions[cloud.fileOrder()[static_cast<std::size_t>(i)]]).norm(),
        1e-5);
}

TEST(PointCloud, KeepsColorsAndIntensitiesWithTheirPoints) {
  const RawPoints raw = randomPoints(1000, {0, 0, 0});
  const PointCloud cloud(raw);
  std::vector<std::uint32_t> order = cloud.fileOrder();
  for (std::size_t i = 0; i < order.size(); ++i) {
    EXPECT_EQ(cloud.colors()[i], raw.colors[order[i]]);
    EXPECT_EQ(cloud.intensities()[i], raw.intensities[order[i]]);
  }
  std::sort(order.begin(), order.end());
  std::vector<std::uint32_t> all(1000);
  std::iota(all.begin(), all.end(), 0U);
  EXPECT_EQ(order, all);
}

TEST(PointCloud, IsTheSameWhateverTheOrderInTheFile) {
  RawPoints raw = randomPoints(1000, {5, 5, 5});
  const PointCloud cloud(raw);
  std::reverse(raw.positions.begin(), raw.positions.end());
  EXPECT_EQ(PointCloud(raw).positions(), cloud.positions());
}

TEST(PointCloud, HasNearPointsNearInMemory) {
  const PointCloud cloud(randomPoints(20000, {0, 0, 0}));
  double along = 0;
  for (Eigen::Index i = 1; i < cloud.size(); ++i)
    along += static_cast<double>((cloud.positions().col(i) - cloud.positions().col(i - 1)).norm());
  EXPECT_LT(along / 20000, 4 * pointSpacing(cloud.positions())); // at random it would be about 100
}

TEST(PointCloud, LeavesOutPointsThatAreNotFinite) {
  RawPoints raw = randomPoints(10, {0, 0, 0});
  raw.positions[3].x() = std::numeric_limits<double>::quiet_NaN();
  raw.positions[7].z() = std::numeric_limits<double>::infinity();
  const PointCloud cloud(raw);
  EXPECT_EQ(cloud.size(), 8);
  EXPECT_TRUE(cloud.positions().allFinite());
  EXPECT_EQ(cloud.colors().size(), 8U);
}

// Their differences or squares would be infinite, although they are not.
TEST(PointCloud, LeavesOutPointsBeyondAnyPlant) {
  const PointCloud cloud(
      RawPoints{.positions = {{1, 2, 3}, {1e300, 0, 0}, {0, -1e300, 0}, {4, 5, 6}}});
  EXPECT_EQ(cloud.size(), 2);
  EXPECT_TRUE(cloud.positions().allFinite());
}

TEST(PointCloud, OfNoPointsIsEmpty) {
  const PointCloud cloud((RawPoints()));
  EXPECT_TRUE(cloud.isEmpty());
  EXPECT_TRUE(cloud.bounds().isEmpty());
}

TEST(PointSpacing, IsTheDistanceOfNeighborsOnAGrid) {
  Eigen::Matrix3Xf grid(3, 1000);
  for (int i = 0; i < 1000; ++i)
    grid.col(i) =
        0.25F * Eigen::Vector3f(static_cast<float>(i % 10), static_cast<float>(i / 10 % 10),
                                static_cast<float>(i / 100));
  EXPECT_NEAR(pointSpacing(grid), 0.25, 1e-6);
}

TEST(PointSpacing, PassesOverDuplicates) {
  Eigen::Matrix3Xf points(3, 4);
  points << 0, 0, 2, 2, 0, 0, 0, 0, 0, 0, 0, 0;
  EXPECT_NEAR(pointSpacing(points), 2, 1e-6);
  EXPECT_EQ(pointSpacing(Eigen::Matrix3Xf::Zero(3, 50)), 0);
}

TEST(PointSpacing, IsTheSameHoweverOftenEachPointIsThere) {
  const RawPoints once = randomPoints(3000, {5, 5, 5});
  const double expected = pointSpacing(PointCloud(once).positions());
  for (const int copies : {2, 8, 9, 20}) {
    RawPoints raw;
    for (int i = 0; i < copies; ++i)
      raw.positions.insert(raw.positions.end(), once.positions.begin(), once.positions.end());
    EXPECT_EQ(pointSpacing(PointCloud(raw).positions()), expected) << copies;
  }
}

} // namespace
} // namespace espalier
