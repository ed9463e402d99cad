#include "core/evaluate/traits/crown.h"
#include "tests/core/evaluate/evaluate_plants.h"
#include "tests/support/plants.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace espalier {
namespace {

/// A trunk of 10 that begins at 5, with a cross of four branches of 3 at 4 above its foot.
Skeleton cross() {
  Skeleton plant;
  const NodeId foot = plant.add({.position = {7, 7, 5}});
  const NodeId fork = plant.add({.position = {7, 7, 9}, .parent = foot});
  plant.add({.position = {7, 7, 15}, .parent = fork});
  for (const auto& [x, y] : {std::pair{3, 0}, {-3, 0}, {0, 3}, {0, -3}})
    plant.add({.position = {7.0 + x, 7.0 + y, 9}, .parent = fork, .edge = EdgeType::branching});
  return plant;
}

TEST(Crown, OfACrossIsKnownOnPaper) {
  const CrownDimensions crown = crownDimensions(cross());
  EXPECT_DOUBLE_EQ(crown.height, 10);
  EXPECT_DOUBLE_EQ(crown.baseHeight, 4);
  EXPECT_DOUBLE_EQ(crown.depth, 6);
  EXPECT_DOUBLE_EQ(crown.area, 18) << "a square on its corner, 6 from corner to corner";
  EXPECT_DOUBLE_EQ(crown.diameter, 2 * std::sqrt(18 / std::numbers::pi));
  EXPECT_DOUBLE_EQ(crown.spread, 6);
}

TEST(Crown, DoesNotDependOnNodesWithinEdgesOrTurnsAboutZ) {
  const Eigen::AngleAxisd turn(0.7, Eigen::Vector3d::UnitZ());
  const Skeleton turned =
      test::placed(test::withMiddleNodes(cross()),
                   [&](const Eigen::Vector3d& p) -> Eigen::Vector3d { return turn * p; });
  const CrownDimensions crown = crownDimensions(turned);
  EXPECT_NEAR(crown.area, 18, 1e-9);
  EXPECT_NEAR(crown.spread, 6, 1e-9);
  EXPECT_NEAR(crown.baseHeight, 4, 1e-9);
}

TEST(Crown, OfATrunkAloneHasNone) {
  const CrownDimensions crown = crownDimensions(test::stick(4));
  EXPECT_EQ(crown.height, 3);
  EXPECT_EQ(crown.depth, 0);
  EXPECT_EQ(crown.area, 0);
  EXPECT_EQ(crownDimensions({}).height, 0);
}

TEST(Crown, OfBranchesInOnePlaneHasNoArea) {
  const CrownDimensions crown = crownDimensions(test::fork(2)); // one branch, to one side
  EXPECT_NEAR(crown.area, 0, 1e-12);
  EXPECT_NEAR(crown.spread, 1, 1e-12);
}

} // namespace
} // namespace espalier
