#include "core/base/error.h"
#include "core/skeleton/select.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using test::forkRoot;
using test::forkTop;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/// 0 < 1 < 2 < 3; on 1 branches 4 < 5; on 4 branches 6. A second tree: 7 < 8.
Skeleton smallForest() {
  Skeleton plant = test::stick(4);
  plant.add({.position = {1, 0, 1}, .radius = 0.05, .parent = NodeId{1}});
  plant.setEdge(NodeId{4}, EdgeType::branching);
  plant.add({.position = {2, 0, 1}, .radius = 0.04, .parent = NodeId{4}});
  plant.add({.position = {1, 1, 1}, .radius = 0.02, .parent = NodeId{4}});
  plant.setEdge(NodeId{6}, EdgeType::branching);
  plant.add({.position = {9, 0, 0}, .radius = 0.1});
  plant.add({.position = {9, 0, 1}, .radius = 0.1, .parent = NodeId{7}});
  return plant;
}

TEST(Downstream, IsAllThatTheNodesCarry) {
  EXPECT_THAT(downstream(smallForest(), {NodeId{4}}),
              UnorderedElementsAre(NodeId{4}, NodeId{5}, NodeId{6}));
}

TEST(Downstream, TakesANodeOnceThatTwoOfTheNodesCarry) {
  EXPECT_THAT(
      downstream(smallForest(), {NodeId{4}, NodeId{2}, NodeId{1}}),
      UnorderedElementsAre(NodeId{1}, NodeId{2}, NodeId{3}, NodeId{4}, NodeId{5}, NodeId{6}));
}

TEST(Upstream, LeadsToTheRoot) {
  EXPECT_THAT(upstream(smallForest(), {NodeId{6}}),
              ElementsAre(NodeId{6}, NodeId{4}, NodeId{1}, NodeId{0}));
}

TEST(Upstream, OfTwoNodesSharesItsLowerPart) {
  EXPECT_THAT(upstream(smallForest(), {NodeId{3}, NodeId{4}}),
              UnorderedElementsAre(NodeId{3}, NodeId{2}, NodeId{1}, NodeId{0}, NodeId{4}));
}

TEST(AxesThrough, AreWholeFromAnyOfTheirNodes) {
  for (const NodeId id : {NodeId{0}, NodeId{2}, NodeId{3}})
    EXPECT_THAT(axesThrough(smallForest(), {id}),
                ElementsAre(NodeId{0}, NodeId{1}, NodeId{2}, NodeId{3}));
  EXPECT_THAT(axesThrough(smallForest(), {NodeId{5}}), ElementsAre(NodeId{4}, NodeId{5}));
}

TEST(AxesThrough, FollowTheFirstOfTwoSuccessors) {
  Skeleton plant = test::fork(2);
  plant.setEdge(NodeId{3}, EdgeType::successor);
  EXPECT_THAT(axesThrough(plant, {forkRoot}), ElementsAre(forkRoot, forkTop, NodeId{2}));
  EXPECT_THAT(axesThrough(plant, {NodeId{3}}), ElementsAre(NodeId{3}));
}

TEST(OfSameOrder, TakesAllNodesOfTheOrders) {
  EXPECT_THAT(ofSameOrder(smallForest(), {NodeId{5}}), UnorderedElementsAre(NodeId{4}, NodeId{5}));
  EXPECT_THAT(ofSameOrder(smallForest(), {NodeId{6}, NodeId{0}}),
              UnorderedElementsAre(NodeId{0}, NodeId{1}, NodeId{2}, NodeId{3}, NodeId{6}, NodeId{7},
                                   NodeId{8}));
}

TEST(TreesOf, LeaveTheOtherTrees) {
  EXPECT_THAT(treesOf(smallForest(), {NodeId{8}}), UnorderedElementsAre(NodeId{7}, NodeId{8}));
  EXPECT_EQ(treesOf(smallForest(), {NodeId{6}, NodeId{7}}).size(), 9U);
}

TEST(OfSimilarRadius, TakesRadiiWithinAShareOfTheMean) {
  EXPECT_THAT(ofSimilarRadius(smallForest(), {NodeId{5}}, 0.25),
              UnorderedElementsAre(NodeId{4}, NodeId{5})); // 0.04 to 0.05
  EXPECT_THAT(ofSimilarRadius(smallForest(), {NodeId{5}}, 0.2), ElementsAre(NodeId{5}));
}

TEST(OfSimilarRadius, RefusesNodesWithoutRadius) {
  Skeleton plant = test::stick(2);
  plant.setRadius(NodeId{0}, 0);
  EXPECT_THROW((void)ofSimilarRadius(plant, {NodeId{0}}, 0.2), Error);
  EXPECT_THROW((void)ofSimilarRadius(plant, {}, 0.2), Error);
}

TEST(Grown, AddsTheLinkedNodes) {
  EXPECT_THAT(grown(smallForest(), {NodeId{4}}),
              UnorderedElementsAre(NodeId{4}, NodeId{1}, NodeId{5}, NodeId{6}));
}

TEST(Shrunk, TakesBackWhatGrowingAddedToAPieceOfAStick) {
  const Skeleton plant = test::stick(9);
  const std::vector<NodeId> piece = {NodeId{3}, NodeId{4}, NodeId{5}};
  EXPECT_THAT(shrunk(plant, grown(plant, piece)), testing::UnorderedElementsAreArray(piece));
  EXPECT_THAT(shrunk(plant, {NodeId{3}, NodeId{4}}), IsEmpty());
}

TEST(Shrunk, LeavesAWholeTree) {
  EXPECT_EQ(shrunk(smallForest(), {NodeId{7}, NodeId{8}}).size(), 2U);
}

TEST(Inverted, IsAllTheRest) {
  EXPECT_THAT(inverted(test::stick(3), {NodeId{1}}), UnorderedElementsAre(NodeId{0}, NodeId{2}));
  EXPECT_THAT(inverted(Skeleton(), {}), IsEmpty());
}

TEST(PathBetween, LeadsOverTheNodeWhereThePathsMeet) {
  EXPECT_THAT(pathBetween(smallForest(), NodeId{3}, NodeId{6}),
              ElementsAre(NodeId{3}, NodeId{2}, NodeId{1}, NodeId{4}, NodeId{6}));
}

TEST(PathBetween, LeadsUpAndDownTheSamePath) {
  EXPECT_THAT(pathBetween(smallForest(), NodeId{0}, NodeId{4}),
              ElementsAre(NodeId{0}, NodeId{1}, NodeId{4}));
  EXPECT_THAT(pathBetween(smallForest(), NodeId{4}, NodeId{0}),
              ElementsAre(NodeId{4}, NodeId{1}, NodeId{0}));
  EXPECT_THAT(pathBetween(smallForest(), NodeId{4}, NodeId{4}), ElementsAre(NodeId{4}));
}

TEST(PathBetween, RefusesTwoTrees) {
  EXPECT_THAT([] { (void)pathBetween(smallForest(), NodeId{3}, NodeId{8}); },
              testing::ThrowsMessage<Error>(testing::HasSubstr("different trees")));
}

TEST(PathOf, OneNodeIsItsAxis) {
  EXPECT_THAT(pathOf(smallForest(), {NodeId{5}}), ElementsAre(NodeId{4}, NodeId{5}));
  EXPECT_EQ(pathOf(smallForest(), {NodeId{3}, NodeId{0}, NodeId{6}}),
            pathBetween(smallForest(), NodeId{3}, NodeId{6}));
}

// Whatever is chosen, it is made of whole parts.
TEST(Select, HoldsForAnyPlant) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const Skeleton plant = test::randomPlant(60, seed);
    for (const NodeId id : plant.ids()) {
      for (const NodeId each : downstream(plant, {id}))
        EXPECT_TRUE(plant.isAncestor(id, each));
      for (const NodeId each : upstream(plant, {id}))
        EXPECT_TRUE(plant.isAncestor(each, id));
      const auto tree = treesOf(plant, {id});
      EXPECT_EQ(inverted(plant, inverted(plant, tree)).size(), tree.size());
      EXPECT_THAT(axesThrough(plant, {id}), testing::Contains(id));
    }
  }
}

TEST(StepFrom, LeadsAlongTheAxisAndToWhatBearsIt) {
  const Skeleton plant = smallForest();
  EXPECT_EQ(stepFrom(plant, NodeId{1}, NodeStep::child), NodeId{2}) << "not to the branch";
  EXPECT_EQ(stepFrom(plant, NodeId{4}, NodeStep::child), NodeId{5});
  EXPECT_EQ(stepFrom(plant, NodeId{3}, NodeStep::child), std::nullopt);
  EXPECT_EQ(stepFrom(plant, NodeId{4}, NodeStep::parent), NodeId{1});
  EXPECT_EQ(stepFrom(plant, NodeId{7}, NodeStep::parent), std::nullopt);
}

TEST(StepFrom, LeadsFromSiblingToSiblingAndAround) {
  const Skeleton plant = smallForest();
  EXPECT_EQ(stepFrom(plant, NodeId{2}, NodeStep::nextSibling), NodeId{4});
  EXPECT_EQ(stepFrom(plant, NodeId{4}, NodeStep::nextSibling), NodeId{2});
  EXPECT_EQ(stepFrom(plant, NodeId{2}, NodeStep::previousSibling), NodeId{4});
  EXPECT_EQ(stepFrom(plant, NodeId{3}, NodeStep::nextSibling), std::nullopt);
  EXPECT_EQ(stepFrom(plant, NodeId{0}, NodeStep::nextSibling), std::nullopt) << "roots have none";
}

} // namespace
} // namespace espalier
