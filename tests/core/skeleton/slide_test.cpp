#include "core/skeleton/slide.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

using Eigen::Vector3d;

/// A line of sight along y, through x and z.
Eigen::ParametrizedLine<double, 3> sight(double x, double z) {
  return {Vector3d(x, -10, z), Vector3d::UnitY()};
}

// Node 1 of the stick stands at z = 1, between 0 and 2.
TEST(SlidAlongAxis, StaysOnTheEdgesOfTheNode) {
  const Skeleton plant = test::stick(3);
  const auto slid = [&](double x, double z) {
    return *slidAlongAxis(plant, NodeId{1}, {0, 0, 1}, sight(x, z));
  };
  EXPECT_TRUE(slid(0.3, 1.4).isApprox(Vector3d(0, 0, 1.4))) << "however far beside it";
  EXPECT_TRUE(slid(-2, 0.6).isApprox(Vector3d(0, 0, 0.6)));
  EXPECT_TRUE(slid(0, 9).isApprox(Vector3d(0, 0, 1.95))) << "clear of the next node";
  EXPECT_TRUE(slid(0, -9).isApprox(Vector3d(0, 0, 0.05))) << "and of the parent";
}

// The axis leads away from the eye: at 45 degrees, 1 beside it is 1 into the depth.
TEST(SlidAlongAxis, LiesWhereTheEyeLooksForItHoweverTheAxisRuns) {
  Skeleton plant;
  const NodeId foot = plant.add({.position = {0, 0, 0}});
  const NodeId middle = plant.add({.position = {1, 1, 0}, .parent = foot});
  plant.add({.position = {2, 2, 0}, .parent = middle});
  EXPECT_TRUE(
      slidAlongAxis(plant, middle, {1, 1, 0}, sight(1.5, 0.2))->isApprox(Vector3d(1.5, 1.5, 0)));
}

// The axis turns by a right angle at the node.
TEST(SlidAlongAxis, TurnsWithTheAxis) {
  Skeleton plant;
  const NodeId foot = plant.add({.position = {0, 0, 0}});
  const NodeId bend = plant.add({.position = {0, 0, 1}, .parent = foot});
  plant.add({.position = {1, 0, 1}, .parent = bend});
  EXPECT_TRUE(
      slidAlongAxis(plant, bend, {0, 0, 1}, sight(0.5, 1.1))->isApprox(Vector3d(0.5, 0, 1)));
  EXPECT_TRUE(
      slidAlongAxis(plant, bend, {0, 0, 1}, sight(-0.1, 0.5))->isApprox(Vector3d(0, 0, 0.5)));
}

TEST(SlidAlongAxis, GoesOnStraightAheadAtBothEndsOfAnAxis) {
  const Skeleton plant = test::stick(3);
  EXPECT_TRUE(
      slidAlongAxis(plant, NodeId{2}, {0, 0, 2}, sight(0.5, 3.5))->isApprox(Vector3d(0, 0, 3.5)));
  EXPECT_TRUE(
      slidAlongAxis(plant, NodeId{0}, {0, 0, 0}, sight(0.5, -0.5))->isApprox(Vector3d(0, 0, -0.5)));
  EXPECT_TRUE(
      slidAlongAxis(plant, NodeId{2}, {0, 0, 2}, sight(0, 1.5))->isApprox(Vector3d(0, 0, 1.5)));
  EXPECT_TRUE(
      slidAlongAxis(plant, NodeId{2}, {0, 0, 2}, sight(0, 1000))->isApprox(Vector3d(0, 0, 12)))
      << "10 edges, and no farther";
}

TEST(SlidAlongAxis, GoesByWhereTheNodeLayAtFirst) {
  Skeleton plant = test::stick(3);
  plant.setPosition(NodeId{1}, {5, 5, 5}); // a drag has begun
  EXPECT_TRUE(
      slidAlongAxis(plant, NodeId{1}, {0, 0, 1}, sight(0, 1.25))->isApprox(Vector3d(0, 0, 1.25)));
}

TEST(SlidAlongAxis, StaysWhereItLiesIfTheAxisIsSeenFromItsEnd) {
  const Skeleton plant = test::stick(3);
  const Eigen::ParametrizedLine<double, 3> down(Vector3d(0.2, 0, 10), -Vector3d::UnitZ());
  EXPECT_EQ(slidAlongAxis(plant, NodeId{1}, {0, 0, 1}, down), Vector3d(0, 0, 1));
}

TEST(SlidAlongAxis, IsNoneForANodeAlone) {
  Skeleton plant;
  const NodeId alone = plant.add({.position = {1, 2, 3}});
  EXPECT_FALSE(slidAlongAxis(plant, alone, {1, 2, 3}, sight(0, 0)));
  plant.add({.position = {1, 2, 3}, .parent = alone});
  EXPECT_FALSE(slidAlongAxis(plant, alone, {1, 2, 3}, sight(0, 0))) << "nor if all coincide";
}

} // namespace
} // namespace espalier
