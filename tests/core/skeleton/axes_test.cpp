#include "core/skeleton/axes.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <cmath>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::ElementsAre;

/// A trunk 0-1-2, a branch 3-4 on node 1, and a twig 5 on node 4.
Skeleton threeOrders() {
  Skeleton plant = test::stick(3);
  plant.add({.position = {1, 0, 1}, .parent = NodeId{1}, .edge = EdgeType::branching});
  plant.add({.position = {3, 0, 1}, .parent = NodeId{3}});
  plant.add({.position = {3, 0, 4}, .parent = NodeId{4}, .edge = EdgeType::branching});
  return plant;
}

TEST(Axes, CountTheBranchingEdgesAsTheOrder) {
  EXPECT_THAT(orders(threeOrders()), ElementsAre(0, 0, 0, 1, 1, 2));
  EXPECT_EQ(order(threeOrders(), NodeId{5}), 2);
}

TEST(Axes, HaveNoOrderWhereANodeWasErased) {
  Skeleton plant = threeOrders();
  plant.erase(NodeId{2});
  EXPECT_EQ(orders(plant)[2], -1);
}

TEST(Axes, IgnoreTheEdgeOfARoot) {
  Skeleton plant = test::stick(2);
  plant.setEdge(NodeId{0}, EdgeType::branching);
  EXPECT_THAT(orders(plant), ElementsAre(0, 0));
}

TEST(Axes, AreTheMaximalChainsOfSuccessors) {
  EXPECT_THAT(axes(threeOrders()), ElementsAre(Axis{NodeId{0}, NodeId{1}, NodeId{2}},
                                               Axis{NodeId{3}, NodeId{4}}, Axis{NodeId{5}}));
}

TEST(Axes, PartAtASecondSuccessor) {
  Skeleton plant = test::fork(2);
  plant.setEdge(NodeId{3}, EdgeType::successor);
  EXPECT_THAT(axes(plant), ElementsAre(Axis{NodeId{0}, NodeId{1}, NodeId{2}}, Axis{NodeId{3}}));
}

TEST(Axes, AreAsLongAsTheirEdgesAndTheOneTheyAreAttachedBy) {
  const Skeleton plant = threeOrders();
  EXPECT_DOUBLE_EQ(length(plant, axes(plant)[0]), 2);
  EXPECT_DOUBLE_EQ(length(plant, axes(plant)[1]), 3);
  EXPECT_DOUBLE_EQ(length(plant, axes(plant)[2]), 3);
}

} // namespace
} // namespace espalier
