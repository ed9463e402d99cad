#include "core/radius/assigned_radii.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>
#include <numbers>

namespace espalier {
namespace {

using testing::ElementsAre;

const Eigen::Vector3d zero = Eigen::Vector3d::Zero();

constexpr AssignedMeasure measures[] = {AssignedMeasure::mean, AssignedMeasure::maximum,
                                        AssignedMeasure::hull};

TEST(AssignedRadii, OfACylinderAreItsRadius) {
  const Skeleton stick = test::stick(5, 0.5);
  const Eigen::Matrix3Xf points = test::cylinder({0, 0, 0}, {0, 0, 2}, 0.07, 0.005);
  const AssignedPoints assigned(stick, points, zero);
  for (const AssignedMeasure measure : measures)
    for (const double radius : assignedRadii(stick, assigned, measure))
      EXPECT_NEAR(radius, 0.07, 0.001);
}

// A half circle has a hull of its arc and its diameter: (pi + 2) r around.
TEST(AssignedRadii, OfAHalfScannedCylinderAreLowByTheHull) {
  Eigen::Matrix3Xf points = test::cylinder({0, 0, 0}, {0, 0, 2}, 0.07, 0.004);
  points.row(0) = points.row(0).cwiseAbs();
  const Skeleton stick = test::stick(5, 0.5);
  const AssignedPoints assigned(stick, points, zero);
  constexpr double half = (std::numbers::pi + 2) / (2 * std::numbers::pi);
  EXPECT_NEAR(assignedRadii(stick, assigned, AssignedMeasure::hull)[2], 0.07 * half, 0.001);
  EXPECT_NEAR(assignedRadii(stick, assigned, AssignedMeasure::mean)[2], 0.07, 0.001);
}

TEST(AssignedRadii, OfTheFarthestLeaveOutATwentieth) {
  Eigen::Matrix3Xf points = test::cylinder({0, 0, 0}, {0, 0, 1}, 0.07, 0.01);
  for (Eigen::Index i = 0; i < points.cols(); i += 30) // 3 % stray
    points.col(i).head<2>() *= 4;
  const Skeleton stick = test::stick(2);
  const AssignedPoints assigned(stick, points, zero);
  EXPECT_NEAR(assignedRadii(stick, assigned, AssignedMeasure::maximum)[0], 0.07, 1e-4);
}

TEST(AssignedRadii, AreNoneForFewPointsOrAHullOnALine) {
  const Skeleton stick = test::stick(2);
  Eigen::Matrix3Xf points(3, 5); // two at the lower half, three in a row at the upper
  points << 1, -1, 1, 2, 3, 0, 0, 0, 0, 0, 0.2F, 0.2F, 0.8F, 0.8F, 0.8F;
  const AssignedPoints assigned(stick, points, zero);
  EXPECT_THAT(assignedRadii(stick, assigned, AssignedMeasure::mean), ElementsAre(0, 2));
  EXPECT_THAT(assignedRadii(stick, assigned, AssignedMeasure::hull), ElementsAre(0, 0));
  const Eigen::Matrix3Xf none(3, 0);
  EXPECT_THAT(assignedRadii(stick, AssignedPoints(stick, none, zero), AssignedMeasure::mean),
              ElementsAre(0, 0));
  EXPECT_TRUE(assignedRadii({}, AssignedPoints({}, points, zero), AssignedMeasure::mean).empty());
}

TEST(AssignedPoints, OfTheFootOfABranchAreTheBranchs) {
  const Skeleton fork = test::fork(2); // node 2 continues the axis, node 3 branches
  ASSERT_EQ(fork[NodeId{3}].edge, EdgeType::branching);
  Eigen::Matrix3Xf points(3, 2);
  for (Eigen::Index i = 0; i < 2; ++i) { // a quarter of each shoot up
    const Eigen::Vector3d& top = fork[test::forkTop].position;
    const Eigen::Vector3d& tip = fork[NodeId{static_cast<std::uint32_t>(2 + i)}].position;
    points.col(i) = (0.75 * top + 0.25 * tip).cast<float>();
  }
  const AssignedPoints assigned(fork, points, zero);
  EXPECT_THAT(assigned.of(test::forkTop), ElementsAre(0));
  EXPECT_THAT(assigned.of(NodeId{2}), testing::IsEmpty());
  EXPECT_THAT(assigned.of(NodeId{3}), ElementsAre(1));
}

TEST(AssignedPoints, AreNotFoundOnceAskedToStop) {
  const Skeleton stick = test::stick(2);
  const Eigen::Matrix3Xf points = test::cylinder({0, 0, 0}, {0, 0, 1}, 0.1, 0.02);
  EXPECT_TRUE(test::stopsWhenAsked(
      [&](const Progress& progress) { AssignedPoints(stick, points, zero, progress); }));
}

TEST(InterpolatedRadii, FollowTheLengthOfTheAxis) {
  Skeleton stick = test::stick(5);
  stick.setPosition(NodeId{2}, {0, 0, 2.5});
  EXPECT_THAT(interpolatedRadii(stick, {0, 4, 0, 2, 0}), ElementsAre(4, 4, 2.5, 2, 2));
  EXPECT_THAT(interpolatedRadii(stick, {0, 0, 0, 0, 0}), ElementsAre(0, 0, 0, 0, 0));
}

TEST(InterpolatedRadii, PassFromAnAxisToItsBranchesAndBack) {
  const Skeleton fork = test::fork(2);
  EXPECT_THAT(interpolatedRadii(fork, {3, 2, 1, 0}), ElementsAre(3, 2, 1, 2));
  EXPECT_THAT(interpolatedRadii(fork, {0, 0, 0, 5}), ElementsAre(5, 5, 5, 5));
}

} // namespace
} // namespace espalier
