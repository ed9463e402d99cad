#include "core/skeleton/length_along.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

using test::forkRoot;
using test::forkTop;

const double shootLength = std::sqrt(2.0); // at 45 degrees, one up and one out

TEST(LengthAlong, AddsUpTheEdgesBetweenTwoNodes) {
  const Skeleton plant = test::stick(5, 0.5);
  EXPECT_NEAR(lengthAlong(plant, {NodeId{1}}, {NodeId{4}}).value(), 1.5, 1e-12);
  EXPECT_NEAR(lengthAlong(plant, {NodeId{4}}, {NodeId{0}}).value(), 2, 1e-12);
  EXPECT_EQ(lengthAlong(plant, {NodeId{2}}, {NodeId{2}}), 0);
}

TEST(LengthAlong, GoesDownToTheBranchingAndUpAgain) {
  const Skeleton plant = test::fork(3);
  const std::vector<NodeId> shoots = plant.children(forkTop);
  EXPECT_NEAR(lengthAlong(plant, {shoots[0]}, {shoots[2]}).value(), 2 * shootLength, 1e-12);
  EXPECT_NEAR(lengthAlong(plant, {shoots[0], 0.25}, {shoots[2], 0.5}).value(), 0.75 * shootLength,
              1e-12);
  EXPECT_NEAR(lengthAlong(plant, {forkRoot}, {shoots[1]}).value(), 1 + shootLength, 1e-12);
}

TEST(LengthAlong, CountsThePartOfAnEdge) {
  const Skeleton plant = test::stick(4);
  EXPECT_NEAR(lengthAlong(plant, {NodeId{1}, 0.25}, {NodeId{1}, 0.75}).value(), 0.5, 1e-12);
  EXPECT_NEAR(lengthAlong(plant, {NodeId{1}, 0.25}, {NodeId{3}, 0.5}).value(), 2.25, 1e-12);
  EXPECT_NEAR(lengthAlong(plant, {NodeId{3}, 0.5}, {NodeId{1}}).value(), 1.5, 1e-12);
}

TEST(LengthAlong, IsAtLeastTheStraightDistance) {
  const Skeleton plant = test::randomPlant(60, 5);
  for (const NodeId id : plant.ids()) {
    const SkeletonPlace from{plant.ids().back(), 0.3};
    const SkeletonPlace to{id, 0.6};
    const auto length = lengthAlong(plant, from, to);
    EXPECT_EQ(length, lengthAlong(plant, to, from)) << "the same both ways";
    const double straight = (positionOf(plant, from) - positionOf(plant, to)).norm();
    EXPECT_TRUE(!length || *length + 1e-9 >= straight);
  }
}

TEST(LengthAlong, IsNoneBetweenTwoTrees) {
  Skeleton plant = test::stick(2);
  const NodeId other = plant.add({.position = {5, 0, 0}});
  EXPECT_EQ(lengthAlong(plant, {NodeId{1}}, {other}), std::nullopt);
}

TEST(PositionOf, LiesOnTheEdge) {
  const Skeleton plant = test::stick(3);
  EXPECT_TRUE(positionOf(plant, {NodeId{2}, 0.25}).isApprox(Eigen::Vector3d(0, 0, 1.25)));
  EXPECT_TRUE(positionOf(plant, {NodeId{0}, 0.25}).isZero()) << "a root has no edge";
}

} // namespace
} // namespace espalier
