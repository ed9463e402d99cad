#include "core/base/error.h"
#include "core/base/random.h"
#include "core/simulate/wood.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace espalier {
namespace {

using Eigen::Vector3d;

const EdgeSolid cylinder{{{0, 0, 0}, {0, 0, 2}, 0.5, 0.5}, NodeId{7}};
const EdgeSolid cone{{{0, 0, 0}, {0, 0, 4}, 2, 1}, NodeId{1}};

TEST(Wood, IsHitOnTheNearSideOfACylinder) {
  const auto found = hit(cylinder, {{-10, 0, 1}, {1, 0, 0}});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->range, 9.5, 1e-12);
  EXPECT_NEAR((found->normal - Vector3d(-1, 0, 0)).norm(), 0, 1e-12);
  EXPECT_EQ(found->node, NodeId{7});
}

// At height 2 the cone is 1.5 wide; its side leans by 1 in 4.
TEST(Wood, IsHitOnTheSlantedSideOfACone) {
  const auto found = hit(cone, {{0, -8, 2}, {0, 1, 0}});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->range, 6.5, 1e-12);
  EXPECT_NEAR((found->normal - Vector3d(0, -4, 1).normalized()).norm(), 0, 1e-12);
}

TEST(Wood, IsHitOnTheBallAtItsUpperEnd) {
  const auto found = hit(cylinder, {{0.3, 0, 9}, {0, 0, -1}});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->range, 9 - 2 - 0.4, 1e-12); // 0.3, 0.4, 0.5
}

TEST(Wood, IsMissedBesideBelowAndBehind) {
  EXPECT_FALSE(hit(cylinder, {{-10, 0.6, 1}, {1, 0, 0}}));
  EXPECT_FALSE(hit(cylinder, {{-10, 0, -0.1}, {1, 0, 0}}));
  EXPECT_FALSE(hit(cylinder, {{-10, 0, 1}, {-1, 0, 0}}));
}

TEST(Wood, FindsAThinTwigFromFarAway) {
  const EdgeSolid twig{{{0, 0, 0}, {0, 0, 1}, 1e-3, 1e-3}, {}};
  const auto found = hit(twig, {{-1000, 0, 0.5}, {1, 0, 0}});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->range, 1000 - 1e-3, 1e-9);
}

TEST(Wood, MeasuresTheDistanceToEachOfItsSides) {
  EXPECT_NEAR(signedDistance(cylinder, {3, 0, 1}), 2.5, 1e-12);
  EXPECT_NEAR(signedDistance(cylinder, {0, 0.2, 1}), -0.3, 1e-12);
  EXPECT_NEAR(signedDistance(cylinder, {0, 0, 5}), 2.5, 1e-12);
  EXPECT_NEAR(signedDistance(cylinder, {3.5, 0, -4}), 5, 1e-12); // to the lower rim: 3, 4, 5
  EXPECT_NEAR(signedDistance(cone, {0, 1.5, 2}), 0, 1e-12);
}

TEST(Wood, HasNoDistanceWhereARayEntersIt) {
  Random random(5);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    Vector3d from = random.uniform(6, 9) * random.direction();
    from.z() = 4 + std::abs(from.z()); // not through the open lower end
    const Vector3d at = Vector3d(0, 0, 2) + 2.5 * random.uniform() * random.direction();
    const Ray ray{from, (at - from).normalized()};
    const auto found = hit(cone, ray);
    if (!found) continue;
    ++hits;
    EXPECT_NEAR(signedDistance(cone, ray.origin + found->range * ray.direction), 0, 1e-9);
    EXPECT_LT(found->normal.dot(ray.direction), 0);
  }
  EXPECT_GT(hits, 500);
}

TEST(Wood, RefusesNodesWithoutRadiusOrPlace) {
  Skeleton plant = test::stick(3);
  plant.setRadius(NodeId{2}, 0);
  EXPECT_THROW(static_cast<void>(woodOf(plant)), Error);
  plant = test::stick(3);
  plant.setPosition(NodeId{1}, {0, std::numeric_limits<double>::quiet_NaN(), 0});
  EXPECT_THROW(static_cast<void>(woodOf(plant)), Error);
}

TEST(Wood, OfAnEdgeWithoutLengthIsABall) {
  const EdgeSolid ball{{{1, 0, 0}, {1, 0, 0}, 0.5, 0.5}, {}};
  const auto found = hit(ball, {{-10, 0, 0}, {1, 0, 0}});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->range, 10.5, 1e-12);
  EXPECT_NEAR(signedDistance(ball, {1, 0, 2}), 1.5, 1e-12);
}

} // namespace
} // namespace espalier
