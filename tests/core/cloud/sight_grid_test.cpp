#include "core/cloud/sight_grid.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

struct SightGridTest : testing::Test {
  const Eigen::Vector3d corner = Eigen::Vector3d::Ones();
  SightGrid grid{Eigen::AlignedBox3d(-corner, corner), 0.05};
  const Eigen::Vector3d middle = Eigen::Vector3d::Zero();

  void addWall(double y, double spacing, double width) { // across the y axis
    for (double x = -0.9; x < 0.9; x += spacing)
      for (double z = -0.9; z < 0.9; z += spacing)
        grid.add({x, y, z}, width);
  }
};

TEST_F(SightGridTest, SeesThroughWhatIsEmpty) {
  EXPECT_EQ(grid.seen(middle, {0, 5, 0}, 0), 1);
}

TEST_F(SightGridTest, SeesNothingBehindAWallOfPoints) {
  addWall(0.5, 0.02, 0.02);
  EXPECT_LT(grid.seen(middle, {0.3, 5, 0.2}, 0), 0.2);
  EXPECT_EQ(grid.seen(middle, {0, -5, 0}, 0), 1) << "from the other side";
  EXPECT_EQ(grid.seen(middle, {0, 0.4, 0}, 0), 1) << "from before the wall";
}

TEST_F(SightGridTest, SeesAPartBehindThinWood) {
  addWall(0.5, 0.02, 0.01); // a fourth of it is covered
  EXPECT_NEAR(grid.seen(middle, {0.02, 5, 0.02}, 0), 0.75, 0.12);
}

TEST_F(SightGridTest, IsNotHiddenByWhatIsNearerThanItsOwnSurface) {
  addWall(0.1, 0.02, 0.02);
  EXPECT_EQ(grid.seen(middle, {0, 5, 0}, 0.2), 1);
}

TEST_F(SightGridTest, PassesOverWhatIsOutsideOfItsBox) {
  grid.add({0, 3, 0}, 1);
  EXPECT_EQ(grid.seen(middle, {0, 5, 0}, 0), 1);
  EXPECT_EQ(grid.seen({0, 3, 0}, {0, 5, 0}, 0), 1);
}

} // namespace
} // namespace espalier
