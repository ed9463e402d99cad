#include "core/base/random.h"
#include "core/surface/convex_hull.h"
#include "core/surface/subtree_hulls.h"
#include "tests/support/mesh_topology.h"
#include "tests/support/plants.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

namespace espalier {
namespace {

/// The corners of a box, with its middle.
Eigen::Matrix3Xd box(const Eigen::Vector3d& size, const Eigen::Vector3d& from) {
  Eigen::Matrix3Xd points(3, 9);
  for (int i = 0; i < 8; ++i)
    points.col(i) = from + Eigen::Vector3d(i & 1, (i >> 1) & 1, (i >> 2) & 1).cwiseProduct(size);
  points.col(8) = from + size / 2;
  return points;
}

TEST(ConvexHull, OfABoxIsTheBox) {
  const auto hull = convexHull(box({2, 3, 4}, {0, 0, 0}));
  ASSERT_TRUE(hull);
  EXPECT_NEAR(hull->volume, 24, 1e-12);
  EXPECT_NEAR(hull->area, 2 * (6 + 8 + 12), 1e-12);
  EXPECT_EQ(hull->corners.cols(), 8) << "its middle is no corner";
  EXPECT_EQ(hull->triangles.size(), 12U);
}

TEST(ConvexHull, KeepsItsDigitsFarFromTheOrigin) {
  const auto hull = convexHull(box({0.02, 0.03, 0.04}, {652'000, 5'401'000, 250}));
  ASSERT_TRUE(hull);
  EXPECT_NEAR(hull->volume, 24e-6, 1e-9); // doubles there are 1e-9 apart
}

TEST(ConvexHull, IsClosedAndTurnsOut) {
  Random random(1);
  Eigen::Matrix3Xd points(3, 500);
  for (auto column : points.colwise())
    column = random.direction();
  const auto hull = convexHull(points);
  ASSERT_TRUE(hull);
  EXPECT_EQ(hull->corners.cols(), 500) << "all of a sphere are corners";
  EXPECT_EQ(test::topologyOf(500, hull->triangles),
            (test::MeshTopology{.pieces = 1, .boundaryLoops = 0, .eulerCharacteristic = 2}));
  EXPECT_NEAR(test::volumeOf(hull->corners, hull->triangles), hull->volume, 1e-12);
  EXPECT_LT(hull->volume, 4 * std::numbers::pi / 3) << "a sphere of radius 1, from inside";
  EXPECT_GT(hull->volume, 0.95 * 4 * std::numbers::pi / 3);
}

TEST(ConvexHull, IsTheSameBodyInAnyOrder) {
  Random random(2);
  Eigen::Matrix3Xd points(3, 200);
  for (auto column : points.colwise())
    column = random.uniform() * random.direction();
  const auto hull = convexHull(points);
  const auto reversed = convexHull(points.rowwise().reverse());
  ASSERT_TRUE(hull && reversed);
  EXPECT_NEAR(hull->volume, reversed->volume, 1e-12);
  EXPECT_EQ(hull->corners.cols(), reversed->corners.cols());
}

TEST(ConvexHull, OfWhatFillsNoSpaceIsNone) {
  EXPECT_FALSE(convexHull(Eigen::Matrix3Xd(3, 0)));
  EXPECT_FALSE(convexHull(Eigen::Matrix3Xd::Zero(3, 10))) << "one place";
  Eigen::Matrix3Xd line(3, 10);
  for (int i = 0; i < 10; ++i)
    line.col(i) = Eigen::Vector3d(1, 2, 3) * i;
  EXPECT_FALSE(convexHull(line));
  EXPECT_FALSE(convexHull(box({1, 1, 0}, {5, 5, 5}))) << "a plane";
}

// Turned, so that rounding lifts the points off their plane a little.
TEST(ConvexHull, OfATurnedPlaneIsNone) {
  Random random(3);
  const Eigen::AngleAxisd turn(1, Eigen::Vector3d(1, 2, 3).normalized());
  Eigen::Matrix3Xd points(3, 1000);
  for (auto column : points.colwise())
    column = turn * Eigen::Vector3d(random.uniform(), random.uniform(), 0);
  EXPECT_FALSE(convexHull(points));
}

TEST(SubtreeHulls, AreOfThePointsThatABranchCarries) {
  const Skeleton fork = test::fork(4); // shoots lead to (+-1, 0, 2) and (0, +-1, 2)
  const NodeId shoot = fork.children(test::forkTop)[1];
  const Eigen::Vector3d tip = fork[shoot].position;
  RawPoints raw; // a box of leaves about the tip, and one about the foot
  const Eigen::Matrix3Xd atTip = box({0.2, 0.2, 0.2}, tip - Eigen::Vector3d::Constant(0.1));
  const Eigen::Matrix3Xd atFoot = box({0.4, 0.4, 0.4}, Eigen::Vector3d::Constant(-0.2));
  for (Eigen::Index i = 0; i < atTip.cols(); ++i) {
    raw.positions.emplace_back(atTip.col(i));
    raw.positions.emplace_back(atFoot.col(i));
  }
  const auto cloud = std::make_shared<const PointCloud>(std::move(raw));
  const PointDistances distances(cloud, 0.1, fork);
  const auto hulls = subtreeHulls(distances, fork, {shoot, fork.roots().front(), test::forkTop});
  ASSERT_EQ(hulls.size(), 3U);
  ASSERT_TRUE(hulls[0] && hulls[1]);
  EXPECT_NEAR(hulls[0]->volume, 0.008, 1e-6);
  EXPECT_GT(hulls[1]->volume, 0.064) << "all of it";
  const auto without = subtreeHulls(distances, fork, {fork.children(test::forkTop)[0]});
  EXPECT_FALSE(without.front()) << "no point is nearest to another shoot";
}

} // namespace
} // namespace espalier
