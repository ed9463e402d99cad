#include "core/graph/find_root.h"
#include "tests/support/clouds.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(FindRoot, IsAtTheFootOfTheTrunk) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  const Eigen::Vector3f root = points.col(findRoot(points));
  EXPECT_LT(root.z(), 0.07F);
  EXPECT_LT(root.head<2>().norm(), 0.05F);
}

TEST(FindRoot, IsNotDeceivedByALowTwigOrAStrayPoint) {
  const Eigen::Matrix3Xf twig = test::cylinder({1, 0, 0.03}, {1, 0, 0.8}, 0.005, 0.02);
  Eigen::Matrix3Xf stray(3, 1);
  stray << 0.6F, 0.6F, -0.03F;
  const Eigen::Matrix3Xf points = test::both(test::both(stray, twig), test::forkCloud());
  EXPECT_LT(points.col(findRoot(points)).head<2>().norm(), 0.05F);
}

TEST(FindRoot, FollowsTheUpAxis) {
  Eigen::Matrix3Xf points = test::forkCloud();
  points.row(0).swap(points.row(2));
  EXPECT_LT(points(0, findRoot(points, UpAxis::x)), 0.07F);
}

TEST(NearestPoint, IsTheNearest) {
  const Eigen::Matrix3Xf points = test::forkCloud();
  EXPECT_EQ(nearestPoint(points, points.col(123)), 123);
}

} // namespace
} // namespace espalier
