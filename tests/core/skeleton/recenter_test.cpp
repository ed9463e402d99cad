#include "core/base/parallel.h"
#include "core/skeleton/recenter.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace espalier {
namespace {

const Eigen::Vector3d origin(100, 200, 300);

/// A stick of 9 along z about `origin`, its nodes off to the side.
Skeleton crookedStick(double offset) {
  Skeleton plant = test::stick(9, 0.25);
  int side = 1;
  for (const NodeId id : plant.ids()) {
    plant.setPosition(id,
                      plant[id].position + origin + Eigen::Vector3d(side * offset, offset / 2, 0));
    side = -side;
  }
  return plant;
}

double farthestOffAxis(const Skeleton& plant) {
  double farthest = 0;
  for (const NodeId id : plant.ids())
    farthest = std::max(farthest, (plant[id].position - origin).head<2>().norm());
  return farthest;
}

TEST(Recentered, MovesNodesToTheAxisOfTheWood) {
  const Eigen::Matrix3Xf points = test::cylinder({0, 0, -0.1}, {0, 0, 2.1}, 0.05, 0.01);
  EXPECT_LT(farthestOffAxis(recentered(crookedStick(0.02), points, origin,
                                       {.rounds = 4, .leastCoverage = 0.4})),
            0.002);
}

TEST(Recentered, IsNotPulledOutByAScanFromOneSide) {
  const Eigen::Matrix3Xf whole = test::cylinder({0, 0, -0.1}, {0, 0, 2.1}, 0.05, 0.01);
  std::vector<Eigen::Index> seen;
  for (Eigen::Index i = 0; i < whole.cols(); ++i)
    if (whole(0, i) > 0) seen.push_back(i);
  const Eigen::Matrix3Xf half = whole(Eigen::all, seen); // its mean is 0.032 off the axis
  EXPECT_LT(farthestOffAxis(
                recentered(crookedStick(0.01), half, origin, {.rounds = 4, .leastCoverage = 0.4})),
            0.008);
}

// About node 4 only a sixth of the wood is seen, which is no circle.
TEST(Recentered, PutsANodeWithoutACircleBetweenItsNeighbors) {
  const Eigen::Matrix3Xf whole = test::cylinder({0, 0, -0.1}, {0, 0, 2.1}, 0.15, 0.02);
  std::vector<Eigen::Index> seen;
  for (Eigen::Index i = 0; i < whole.cols(); ++i)
    if (std::abs(whole(2, i) - 1) > 0.14F || whole(0, i) > 0.13F) seen.push_back(i);
  const Eigen::Matrix3Xf points = whole(Eigen::all, seen);
  Skeleton plant = crookedStick(0);
  plant.setPosition(NodeId{4}, plant[NodeId{4}].position + Eigen::Vector3d(0.09, 0, 0));
  const auto offAxis = [&](double straightReach) {
    const Skeleton moved =
        recentered(plant, points, origin, {.smoothing = 0, .straightReach = straightReach});
    return (moved[NodeId{4}].position - origin).head<2>().norm();
  };
  EXPECT_LT(offAxis(6), 0.01);
  EXPECT_GT(offAxis(2), 0.08) << "its neighbors are 3.3 radii apart";
}

TEST(Recentered, KeepsLengthAndTopology) {
  const Eigen::Matrix3Xf points = test::cylinder({0, 0, -0.1}, {0, 0, 2.1}, 0.05, 0.01);
  const Skeleton plant = crookedStick(0.02);
  const Skeleton moved = recentered(plant, points, origin);
  EXPECT_EQ(moved.ids(), plant.ids());
  EXPECT_NEAR(moved[NodeId{8}].position.z() - moved[NodeId{0}].position.z(), 2, 0.02);
}

TEST(Recentered, LeavesNodesWithoutPoints) {
  const Skeleton plant = crookedStick(0.02);
  EXPECT_EQ(recentered(plant, Eigen::Matrix3Xf(3, 0), origin), plant);
  EXPECT_TRUE(recentered({}, Eigen::Matrix3Xf::Zero(3, 9), origin).isEmpty());
  const Skeleton alone = test::stick(1);
  EXPECT_EQ(recentered(alone, Eigen::Matrix3Xf::Ones(3, 9), {0, 0, 0}), alone);
}

TEST(Recentered, IsTheSameOnAnyNumberOfThreads) {
  const Eigen::Matrix3Xf points = test::cylinder({0, 0, -0.1}, {0, 0, 2.1}, 0.05, 0.01);
  const Skeleton onMany = recentered(crookedStick(0.02), points, origin);
  const ThreadLimit limit(1);
  EXPECT_EQ(recentered(crookedStick(0.02), points, origin), onMany);
}

TEST(Recentered, StopsWhenAsked) {
  EXPECT_TRUE(test::stopsWhenAsked([](const Progress& progress) {
    (void)recentered(test::stick(3), test::forkCloud(), {0, 0, 0}, {}, progress);
  }));
}

} // namespace
} // namespace espalier
