#include "core/base/error.h"
#include "core/reconstruct/direction_cones.h"
#include "core/reconstruct/point_tracking.h"
#include "tests/support/clouds.h"
#include "tests/support/plants.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr double degreeOfTurn = std::numbers::pi / 180;
constexpr PointTrackingOptions trackingOptions{.leastStep = 0.1,
                                               .greatestStep = 0.1,
                                               .reach = 2,
                                               .kill = 1.2,
                                               .widestGap = 0.3,
                                               .clusterDensity = 1};

Eigen::Vector3d tilted(double angle, double azimuth = 0) {
  return {std::sin(angle) * std::cos(azimuth), std::sin(angle) * std::sin(azimuth),
          std::cos(angle)};
}

/// Points 0.01 apart from one place to another.
Eigen::Matrix3Xf lineOfPoints(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const auto count = static_cast<Eigen::Index>((to - from).norm() / 0.01 + 1.5);
  Eigen::Matrix3Xf points(3, count);
  for (Eigen::Index i = 0; i < count; ++i)
    points.col(i) = (from + static_cast<double>(i) / static_cast<double>(count - 1) * (to - from))
                        .cast<float>();
  return points;
}

Skeleton trackedSkeleton(const Eigen::Matrix3Xf& points, float density = 0.5F,
                         const PointTrackingOptions& with = trackingOptions) {
  const std::vector<float> densities(static_cast<std::size_t>(points.cols()), density);
  return skeletonByPointTracking(points, densities, 0, with);
}

TEST(DirectionCones, StandAheadAndInRingsBelowARightAngle) {
  EXPECT_EQ(DirectionCones(60 * degreeOfTurn).axes({}).size(), 1U + 6U);
  EXPECT_EQ(DirectionCones(45 * degreeOfTurn).axes({}).size(), 1U + 8U);
  EXPECT_EQ(DirectionCones(30 * degreeOfTurn).axes({}).size(), 1U + 12U + 12U);
}

TEST(DirectionCones, GroupWhatTheyHoldAndLeaveOutTheRest) {
  const DirectionCones cones(45 * degreeOfTurn);
  const auto groups =
      cones.groups({}, {tilted(10 * degreeOfTurn), tilted(45 * degreeOfTurn, 45 * degreeOfTurn),
                        tilted(15 * degreeOfTurn, 3), tilted(90 * degreeOfTurn),
                        tilted(180 * degreeOfTurn), Eigen::Vector3d::Zero()});
  ASSERT_EQ(groups.size(), 2U);
  EXPECT_EQ(groups[0], (std::vector<std::size_t>{0, 2})); // ahead
  EXPECT_EQ(groups[1], (std::vector<std::size_t>{1}));
}

TEST(DirectionCones, TurnWithTheHeading) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(1.2, Eigen::Vector3d(1, -2, 0.5).normalized()));
  const DirectionCones cones(45 * degreeOfTurn);
  std::vector<Eigen::Vector3d> directions;
  std::vector<Eigen::Vector3d> turned;
  for (int i = 0; i < 60; ++i) {
    directions.push_back(tilted(i * 3 * degreeOfTurn, i * 37 * degreeOfTurn));
    turned.emplace_back(turn * directions.back());
  }
  const Heading heading{turn * Eigen::Vector3d::UnitZ(), turn * Eigen::Vector3d::UnitX()};
  EXPECT_EQ(cones.groups(heading, turned), cones.groups({}, directions));
}

TEST(Heading, KeepsItsSideAcrossAndTurnsNoMoreThanItMust) {
  const Heading turned =
      Heading{}.turnedTo(tilted(40 * degreeOfTurn, 90 * degreeOfTurn)); // about the side
  EXPECT_LT((turned.side - Eigen::Vector3d::UnitX()).norm(), 1e-12);
  const Heading back = Heading{}.turnedTo(-Eigen::Vector3d::UnitZ());
  EXPECT_NEAR(back.side.dot(back.along), 0, 1e-12);
  EXPECT_NEAR(back.side.norm(), 1, 1e-12);
}

// The last node kills all within 0.12 of it.
TEST(PointTracking, ClimbsALineByEvenSteps) {
  const Skeleton skeleton = trackedSkeleton(lineOfPoints({0, 0, 0}, {0, 0, 1}));
  const std::vector<NodeId> ids = skeleton.ids();
  EXPECT_EQ(ids.size(), 10U); // at 0, 0.1, ..., 0.9
  for (std::size_t i = 0; i < ids.size(); ++i)
    EXPECT_NEAR(skeleton[ids[i]].position.z(), 0.1 * static_cast<double>(i), 1e-5);
}

TEST(PointTracking, StepsByTheDensity) {
  PointTrackingOptions adaptive = trackingOptions;
  adaptive.greatestStep = 0.2;
  EXPECT_EQ(trackedSkeleton(lineOfPoints({0, 0, 0}, {0, 0, 1}), 0, adaptive).size(), 10U);
  EXPECT_EQ(trackedSkeleton(lineOfPoints({0, 0, 0}, {0, 0, 1}), 1, adaptive).size(), 5U);
}

TEST(PointTracking, ForksWhereThePointsDo) {
  for (const double angle : {30 * degreeOfTurn, 45 * degreeOfTurn, 60 * degreeOfTurn}) {
    const Eigen::Vector3d fork(0, 0, 1);
    const Eigen::Matrix3Xf points = test::both(
        lineOfPoints({0, 0, 0}, fork), test::both(lineOfPoints(fork, fork + tilted(angle)),
                                                  lineOfPoints(fork, fork + tilted(-angle))));
    const Skeleton skeleton = trackedSkeleton(points);
    EXPECT_GE(test::countTips(skeleton), 2) << angle / degreeOfTurn;
    for (const double side : {-angle, angle}) {
      double nearest = 1;
      for (const NodeId id : skeleton.ids())
        nearest = std::min(nearest, (skeleton[id].position - fork - tilted(side)).norm());
      EXPECT_LT(nearest, 0.2) << angle / degreeOfTurn; // a node kills 0.12 around it, and steps 0.1
    }
  }
}

TEST(PointTracking, FindsASideBranchAtARightAngle) {
  const Eigen::Matrix3Xf points =
      test::both(lineOfPoints({0, 0, 0}, {0, 0, 2}), lineOfPoints({0, 0, 1.05}, {1, 0, 1.35}));
  double farthest = 0;
  const Skeleton skeleton = trackedSkeleton(points);
  for (const NodeId id : skeleton.ids())
    farthest = std::max(farthest, skeleton[id].position.x());
  EXPECT_GT(farthest, 0.85);
}

// From the root, four upright rods lie in four directions; their wood runs in one.
TEST(PointTracking, ClustersDirectionsToPointsOrThoseOfTheWood) {
  Eigen::Matrix3Xf rods = Eigen::Vector3f::Zero(); // the root
  for (const Eigen::Vector3d& side : {Eigen::Vector3d(0.1, 0, 0), Eigen::Vector3d(-0.1, 0, 0),
                                      Eigen::Vector3d(0, 0.1, 0), Eigen::Vector3d(0, -0.1, 0)})
    rods = test::both(rods, lineOfPoints(side, side + Eigen::Vector3d(0, 0, 1)));
  PointTrackingOptions options = trackingOptions;
  options.clusterDensity = 0;
  const Skeleton toPoints = trackedSkeleton(rods, 0.5F, options);
  EXPECT_EQ(toPoints.children(toPoints.roots().front()).size(), 4U);
  options.clustered = ClusteredDirections::ofWood;
  const Skeleton ofWood = trackedSkeleton(rods, 0.5F, options);
  EXPECT_EQ(ofWood.children(ofWood.roots().front()).size(), 1U);
}

TEST(PointTracking, GrowsIntoNoConeOfFewPoints) {
  Eigen::Matrix3Xf few(3, 2); // in the shell of the node at 0.5, far off the lineOfPoints
  few << 0.13F, 0.13F, 0, 0, 0.58F, 0.59F;
  const Skeleton skeleton = trackedSkeleton(test::both(lineOfPoints({0, 0, 0}, {0, 0, 1}), few));
  EXPECT_EQ(test::countTips(skeleton), 1);
  PointTrackingOptions any = trackingOptions;
  any.fewestPoints = 1;
  EXPECT_GT(test::countTips(
                trackedSkeleton(test::both(lineOfPoints({0, 0, 0}, {0, 0, 1}), few), 0.5F, any)),
            1);
}

TEST(PointTracking, EndsBeforeAGapWiderThanItsReach) {
  const Skeleton skeleton = trackedSkeleton(
      test::both(lineOfPoints({0, 0, 0}, {0, 0, 1}), lineOfPoints({0, 0, 1.4}, {0, 0, 2})));
  for (const NodeId id : skeleton.ids())
    EXPECT_LT(skeleton[id].position.z(), 1.1);
}

TEST(PointTracking, RefusesARootThatReachesLessThanHalf) {
  EXPECT_THROW((void)trackedSkeleton(test::both(lineOfPoints({0, 0, 0}, {0, 0, 0.5}),
                                                lineOfPoints({9, 0, 0}, {9, 0, 3}))),
               Error);
}

TEST(PointTracking, MakesOneNodeOfCoincidentPoints) {
  EXPECT_EQ(trackedSkeleton(Eigen::Matrix3Xf::Ones(3, 50)).size(), 1U);
  EXPECT_EQ(trackedSkeleton(Eigen::Matrix3Xf::Ones(3, 1)).size(), 1U);
}

} // namespace
} // namespace espalier
