#include "core/skeleton/propose_child.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

using Eigen::Vector3d;

const auto toNothing = [](const Vector3d& place) -> Vector3d { return place; };

TEST(ProposeChild, ContinuesTheSegmentOfAnApex) {
  const Skeleton plant = test::stick(3);
  const Vector3d place = proposeChild(plant, NodeId{2}, Vector3d::UnitY(), 0.1, toNothing);
  EXPECT_TRUE(place.isApprox(Vector3d(0, 0, 3)));
}

TEST(ProposeChild, GrowsALoneRootUpward) {
  const Skeleton plant = test::stick(1);
  const Vector3d place = proposeChild(plant, NodeId{0}, Vector3d::UnitY(), 0.1, toNothing);
  EXPECT_TRUE(place.isApprox(Vector3d(0, 0, 0.1)));
}

TEST(ProposeChild, KeepsAwayFromTheOtherNeighbors) {
  const Skeleton plant =
      test::stick(3); // seen along y, a child of the middle belongs left or right
  const Vector3d place = proposeChild(plant, NodeId{1}, Vector3d::UnitY(), 0.1, toNothing);
  EXPECT_NEAR((place - Vector3d(0, 0, 1)).norm(), 1, 1e-12);
  EXPECT_GT(std::abs(place.x()), 0.9);
  EXPECT_NEAR(place.y(), 0, 1e-12);
}

TEST(ProposeChild, SnapsToThePoints) {
  const auto aside = [](const Vector3d& place) { return Vector3d(place + Vector3d(0.2, 0, 0)); };
  const Vector3d place = proposeChild(test::stick(3), NodeId{2}, Vector3d::UnitY(), 0.1, aside);
  EXPECT_TRUE(place.isApprox(Vector3d(0.2, 0, 3)));
}

TEST(ProposeChild, DoesNotSnapBackToItsParent) {
  const auto back = [](const Vector3d&) { return Vector3d(0, 0, 2.1); };
  const Vector3d place = proposeChild(test::stick(3), NodeId{2}, Vector3d::UnitY(), 0.1, back);
  EXPECT_TRUE(place.isApprox(Vector3d(0, 0, 3)));
}

TEST(ProposeChild, NeedsNoLengthOfTheEdgeBelow) {
  Skeleton plant = test::stick(2, 0); // both nodes at one place
  const Vector3d place = proposeChild(plant, NodeId{1}, Vector3d::UnitY(), 0.5, toNothing);
  EXPECT_TRUE(place.isApprox(Vector3d(0, 0, 0.5)));
}

} // namespace
} // namespace espalier
