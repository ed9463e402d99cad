#include "core/cloud/isolated_points.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace espalier {
namespace {

const Eigen::Matrix3Xf plant = test::forkCloud();

TEST(IsolatedPoints, AreThoseFarFromAllOthers) {
  Eigen::Matrix3Xf strays(3, 3);
  strays << 1, -1, 0.5F, 0.7F, 0.7F, 0.4F, 0.5F, 1, 3.9F;
  const Eigen::Matrix3Xf points = test::both(plant, strays);
  const std::vector<bool> isolated =
      isolatedPoints(SpatialIndex(points), {.neighbors = 8, .distance = 0.16});
  EXPECT_EQ(std::count(isolated.begin(), isolated.end(), true), 3);
  EXPECT_TRUE(std::all_of(isolated.end() - 3, isolated.end(), [](bool b) { return b; }));
}

TEST(IsolatedPoints, AreNoneAmongFewPoints) {
  const Eigen::Matrix3Xf few = plant.leftCols(5);
  const std::vector<bool> isolated =
      isolatedPoints(SpatialIndex(few), {.neighbors = 8, .distance = 1e-9});
  EXPECT_EQ(isolated, std::vector<bool>(5, false));
}

TEST(IsolatedPoints, StopWhenAsked) {
  EXPECT_TRUE(test::stopsWhenAsked([](const Progress& progress) {
    (void)isolatedPoints(SpatialIndex(plant), {.neighbors = 8, .distance = 1}, progress);
  }));
}

} // namespace
} // namespace espalier
