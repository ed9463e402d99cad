#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/graph/find_root.h"
#include "core/reconstruct/thick_wood.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

/// A trunk along z, 2 high, radius 0.2, and a twig of radius 0.01 that stands off from it.
struct TrunkAndTwig {
  Eigen::Matrix3Xf trunk = test::cylinder({0, 0, 0}, {0, 0, 2}, 0.2, 0.02);
  Eigen::Matrix3Xf twig = test::cylinder({0.22, 0, 1}, {1.2, 0, 1.5}, 0.01, 0.02);
  Eigen::Matrix3Xf points = test::both(trunk, twig);

  [[nodiscard]] Eigen::Matrix3Xf moved(double radius) const {
    return withThickWoodAsLines(points, findRoot(points), {.radius = radius});
  }
};

TEST(ThickWood, IsDrawnToItsAxis) {
  const TrunkAndTwig plant;
  const Eigen::Matrix3Xf moved = plant.moved(0.05);
  for (Eigen::Index i = 0; i < plant.trunk.cols(); ++i) {
    const float z = plant.points(2, i);
    if (z < 0.6F || z > 1.6F) continue; // the root is on one side: bins wind up from there
    EXPECT_LT(moved.col(i).head<2>().norm(), 0.05) << "at " << z;
    EXPECT_NEAR(moved(2, i), z, 0.25) << "and stays where it is along it";
  }
}

TEST(ThickWood, LeavesThinWoodToTheBit) {
  const TrunkAndTwig plant;
  const Eigen::Matrix3Xf moved = plant.moved(0.05);
  Eigen::Index same = 0;
  for (Eigen::Index i = plant.trunk.cols(); i < plant.points.cols(); ++i)
    if (moved.col(i) == plant.points.col(i)) ++same;
  EXPECT_GT(same, plant.twig.cols() * 17 / 20) << "all but 0.15 that share a bin with the trunk";
}

TEST(ThickWood, IsNoneThatIsThinnerThanAskedFor) {
  const TrunkAndTwig plant;
  EXPECT_EQ(plant.moved(0.5), plant.points);
  EXPECT_EQ(plant.moved(0), plant.points);
}

TEST(ThickWood, IsTheSameOnAnyNumberOfThreads) {
  const TrunkAndTwig plant;
  const Eigen::Matrix3Xf onMany = plant.moved(0.05);
  const ThreadLimit limit(1);
  EXPECT_EQ(plant.moved(0.05), onMany);
}

TEST(ThickWood, RefusesARootThatHalfOfThePointsAreNotConnectedTo) {
  const Eigen::Matrix3Xf points = test::both(test::cylinder({0, 0, 0}, {0, 0, 0.2}, 0.05, 0.02),
                                             test::cylinder({5, 0, 0}, {5, 0, 2}, 0.05, 0.02));
  EXPECT_THROW((void)withThickWoodAsLines(points, 0, {.radius = 0.05, .widestGap = 1}), Error);
}

TEST(ThickWood, StopsWhenAsked) {
  const TrunkAndTwig plant;
  EXPECT_TRUE(test::stopsWhenAsked([&](const Progress& progress) {
    (void)withThickWoodAsLines(plant.points, 0, {.radius = 0.05}, progress);
  }));
}

} // namespace
} // namespace espalier
