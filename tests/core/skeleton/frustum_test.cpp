#include "core/skeleton/frustum.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <numbers>

namespace espalier {
namespace {

using Eigen::Vector3d;

const Frustum cylinder{{0, 0, 0}, {0, 0, 2}, 0.5, 0.5};
const Frustum cone{{0, 0, 0}, {0, 0, 4}, 2, 1};

// Slant height of a frustum of radii 2 and 1 and height 4 is sqrt(17).
TEST(Frustum, HasAnAreaAndAVolume) {
  EXPECT_NEAR(cylinder.lateralArea(), 2 * std::numbers::pi, 1e-12);
  EXPECT_NEAR(cone.lateralArea(), 3 * std::numbers::pi * std::sqrt(17.0), 1e-12);
  EXPECT_NEAR(cylinder.volume(), std::numbers::pi / 2, 1e-12);
  EXPECT_NEAR(cone.volume(), std::numbers::pi / 3 * 4 * 7, 1e-12);
}

TEST(Frustum, IsInItsBox) {
  EXPECT_EQ(cone.box().min(), Vector3d(-2, -2, -2));
  EXPECT_EQ(cone.box().max(), Vector3d(2, 2, 5));
  EXPECT_EQ(cone.centerBox().max(), Vector3d(0, 0, 4));
}

TEST(Frustum, TapersAlongAnAxisButStartsABranchWithItsOwnRadius) {
  Skeleton plant = test::fork(2);
  plant.setRadius(test::forkTop, 0.3);
  const std::vector<EdgeBody> edges = bodiesOf(plant);
  ASSERT_EQ(edges.size(), 3U); // a root that carries something has none
  EXPECT_EQ(edges[0].body.fromRadius, 0.1);
  EXPECT_EQ(edges[0].body.toRadius, 0.3);
  EXPECT_EQ(edges[1].body.fromRadius, 0.3); // the successor
  EXPECT_EQ(edges[2].body.fromRadius, 0.1); // the branch
}

TEST(Frustum, IsACylinderAboveANodeWithoutRadius) {
  Skeleton stick = test::stick(3);
  stick.setRadius(NodeId{0}, 0);
  stick.setRadius(NodeId{2}, 0);
  EXPECT_EQ(frustumOf(stick, NodeId{1})->fromRadius, 0.1);
  EXPECT_EQ(frustumOf(stick, NodeId{2})->fromRadius, 0.1); // and below one it narrows to nothing
  EXPECT_EQ(frustumOf(stick, NodeId{2})->toRadius, 0);
}

TEST(Frustum, OfARootThatCarriesNothingIsABall) {
  const Frustum ball = *frustumOf(test::stick(1), NodeId{0});
  EXPECT_EQ(ball.length(), 0);
  EXPECT_EQ(ball.fromRadius, 0.1);
  EXPECT_EQ(ball.nearestShare({1, 2, 3}), 1);
  EXPECT_FALSE(frustumOf(test::stick(2), NodeId{0}));
}

TEST(Frustum, IsNearestToPlacesAcrossItAndBeyondItsEnds) {
  EXPECT_EQ(cone.nearestShare({7, 0, 1}), 0.25);
  EXPECT_EQ(cone.radiusAt(0.25), 1.75);
  EXPECT_EQ(cone.at(0.25), Vector3d(0, 0, 1));
  EXPECT_EQ(cone.nearestShare({0, 1, -3}), 0);
  EXPECT_EQ(cone.nearestShare({0, 1, 9}), 1);
}

TEST(Frustum, OfTwoHasANearestPlaceOnEach) {
  const NearestShares near = nearestShares(cone, {{3, -1, 2}, {3, 3, 2}});
  EXPECT_NEAR(near.distance, 3, 1e-12);
  EXPECT_NEAR(near.a, 0.5, 1e-12);
  EXPECT_NEAR(near.b, 0.25, 1e-12);
}

} // namespace
} // namespace espalier
