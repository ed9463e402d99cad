#include "core/skeleton/assemble_axes.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(AssembleAxes, LetsTheHeaviestChildContinue) {
  Skeleton plant = test::fork(3);
  plant.add({.position = {-1, 1, 3}, .parent = NodeId{3}});
  plant = withAssembledAxes(plant);
  EXPECT_EQ(plant[NodeId{3}].edge, EdgeType::successor);
  EXPECT_EQ(plant[NodeId{2}].edge, EdgeType::branching);
  EXPECT_EQ(plant[NodeId{4}].edge, EdgeType::branching);
}

TEST(AssembleAxes, CountsLengthNotNodes) {
  Skeleton plant = test::fork(2);
  plant.setPosition(NodeId{2}, {0, 0, 5}); // one long edge
  NodeId at{3};
  for (int i = 0; i < 5; ++i)
    at = plant.add({.position = {-1, 0, 2 + 0.1 * i}, .parent = at});
  EXPECT_EQ(withAssembledAxes(plant)[NodeId{2}].edge, EdgeType::successor);
}

TEST(AssembleAxes, EndsAnAxisAtATooSharpTurn) {
  Skeleton plant = test::stick(2);
  plant.add({.position = {5, 0, 1}, .parent = NodeId{1}}); // 90 degrees off
  EXPECT_EQ(withAssembledAxes(plant)[NodeId{2}].edge, EdgeType::branching);
  EXPECT_EQ(withAssembledAxes(plant, {.sharpestTurn = 1.6})[NodeId{2}].edge, EdgeType::successor);
}

TEST(AssembleAxes, LooksPastAKinkOfOneEdge) {
  Skeleton plant = test::stick(6);
  NodeId at{5};
  at = plant.add({.position = {0.1, 0, 5}, .parent = at}); // a short step aside
  for (int i = 1; i < 6; ++i)
    at = plant.add({.position = {0.1, 0, 5.0 + i}, .parent = at});
  EXPECT_EQ(withAssembledAxes(plant)[NodeId{6}].edge, EdgeType::successor);
  EXPECT_EQ(withAssembledAxes(plant, {.reach = 1})[NodeId{6}].edge, EdgeType::branching);
}

TEST(AssembleAxes, GivesEachNodeAtMostOneSuccessor) {
  const Skeleton plant = withAssembledAxes(test::randomPlant(300, 1), {.sharpestTurn = 3.2});
  for (const NodeId id : plant.ids()) {
    int successors = 0;
    for (const NodeId child : plant.children(id))
      successors += plant[child].edge == EdgeType::successor ? 1 : 0;
    EXPECT_EQ(successors, plant.children(id).empty() ? 0 : 1);
  }
}

} // namespace
} // namespace espalier
