#include "core/skeleton/edits.h"
#include "core/skeleton/select.h"
#include "core/skeleton/tree_edits.h"
#include "tests/core/skeleton/edited.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <functional>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using test::edited;
using test::expectRefused;
using test::forkRoot;
using test::forkTop;
using testing::ElementsAre;

EdgeType edge(const Skeleton& plant, int id) {
  return plant[NodeId{static_cast<std::uint32_t>(id)}].edge;
}

/// A stick of `below` nodes, and a second one of `above` nodes straight above it.
Skeleton twoSticks(int below, int above) {
  Skeleton plant = test::stick(below);
  std::optional<NodeId> parent;
  for (int i = 0; i < above; ++i)
    parent = plant.add({.position = {0, 0, 1.0 * below + i}, .radius = 0.1, .parent = parent});
  return plant;
}

TEST(SwapSuccessor, LetsTheNextChildContinue) {
  Skeleton plant = test::fork(3);
  for (const int next : {3, 4, 2}) { // around
    plant = edited(plant, [](SkeletonEditor& editor) { swapSuccessor(editor, forkTop); });
    for (const int child : {2, 3, 4})
      EXPECT_EQ(edge(plant, child), child == next ? EdgeType::successor : EdgeType::branching);
  }
}

TEST(SwapSuccessor, LetsTheFirstContinueWhereNoneDid) {
  Skeleton plant = test::fork(2);
  plant.setEdge(NodeId{2}, EdgeType::branching);
  plant = edited(plant, [](SkeletonEditor& editor) { swapSuccessor(editor, forkTop); });
  EXPECT_EQ(edge(plant, 2), EdgeType::successor);
}

TEST(SwapSuccessor, RefusesANodeThatDoesNotBranch) {
  expectRefused(test::fork(2), "does not branch",
                [](SkeletonEditor& editor) { swapSuccessor(editor, forkRoot); });
}

TEST(CutOff, MakesASubtreeATree) {
  const Skeleton plant =
      edited(test::fork(3), [](SkeletonEditor& editor) { cutOff(editor, forkTop); });
  EXPECT_THAT(plant.roots(), ElementsAre(forkRoot, forkTop));
  EXPECT_EQ(plant.children(forkTop).size(), 3U);
}

TEST(CutOff, RefusesARoot) {
  expectRefused(test::fork(3), "is a root already",
                [](SkeletonEditor& editor) { cutOff(editor, forkRoot); });
}

TEST(JoinTree, AttachesARootWhereItContinues) {
  const Skeleton plant = edited(
      twoSticks(2, 2), [](SkeletonEditor& editor) { joinTree(editor, NodeId{2}, NodeId{1}); });
  EXPECT_EQ(plant, test::stick(4));
}

TEST(JoinTree, TakesBackACut) {
  const Skeleton plant = edited(test::stick(4), [](SkeletonEditor& editor) {
    cutOff(editor, NodeId{2});
    joinTree(editor, NodeId{2}, NodeId{1});
  });
  EXPECT_EQ(plant, test::stick(4));
}

TEST(JoinTree, TurnsAFragmentAroundThatIsAttachedByItsTip) {
  const Skeleton plant = edited(
      twoSticks(2, 3), [](SkeletonEditor& editor) { joinTree(editor, NodeId{4}, NodeId{0}); });
  EXPECT_THAT(plant.roots(), ElementsAre(NodeId{0}));
  EXPECT_EQ(plant[NodeId{4}].parent, NodeId{0});
  EXPECT_EQ(plant[NodeId{3}].parent, NodeId{4});
  EXPECT_EQ(plant[NodeId{2}].parent, NodeId{3});
  EXPECT_EQ(edge(plant, 4), EdgeType::branching) << "node 1 continues";
  EXPECT_EQ(edge(plant, 3), EdgeType::successor);
}

TEST(JoinTree, RefusesNodesOfOneTree) {
  expectRefused(test::fork(3), "belong to one tree",
                [](SkeletonEditor& editor) { joinTree(editor, NodeId{2}, NodeId{3}); });
}

TEST(NearestInOtherTree, LooksPastTheOwnTree) {
  EXPECT_EQ(nearestInOtherTree(twoSticks(3, 2), NodeId{3}), NodeId{2});
  EXPECT_EQ(nearestInOtherTree(twoSticks(3, 2), NodeId{0}), NodeId{3});
  EXPECT_THROW((void)nearestInOtherTree(test::stick(3), NodeId{0}), Error);
}

TEST(Reroot, LetsAStickGrowTheOtherWay) {
  const Skeleton plant =
      edited(test::stick(4), [](SkeletonEditor& editor) { reroot(editor, NodeId{3}); });
  EXPECT_THAT(plant.ids(), ElementsAre(NodeId{3}, NodeId{2}, NodeId{1}, NodeId{0}));
  for (const int id : {0, 1, 2})
    EXPECT_EQ(edge(plant, id), EdgeType::successor);
}

TEST(Reroot, KeepsTheSuccessorsOffThePath) { // 3 is the true foot: 1 < 2 goes on as it was
  const Skeleton plant =
      edited(test::fork(2), [](SkeletonEditor& editor) { reroot(editor, NodeId{3}); });
  EXPECT_THAT(plant.roots(), ElementsAre(NodeId{3}));
  EXPECT_EQ(edge(plant, 1), EdgeType::successor) << "the only child of the new root";
  EXPECT_EQ(edge(plant, 2), EdgeType::successor);
  EXPECT_EQ(edge(plant, 0), EdgeType::branching);
}

TEST(Reroot, ComesBackOnAStickAndChangesNothingAtARoot) {
  const Skeleton plant = edited(test::stick(4), [](SkeletonEditor& editor) {
    reroot(editor, NodeId{3});
    reroot(editor, NodeId{0});
    reroot(editor, NodeId{0});
  });
  EXPECT_EQ(plant, test::stick(4));
}

TEST(ReversePath, TurnsABranchThatIsAttachedByItsTip) {
  Skeleton plant = test::stick(2);
  plant.add({.position = {3, 0, 0}, .parent = NodeId{1}, .edge = EdgeType::branching});
  plant.add({.position = {2, 0, 0}, .parent = NodeId{2}});
  plant.add({.position = {1, 0, 0}, .parent = NodeId{3}});
  plant.add({.position = {2, 1, 0}, .parent = NodeId{3}, .edge = EdgeType::branching});
  plant = edited(plant, [](SkeletonEditor& editor) { reversePath(editor, NodeId{2}, NodeId{4}); });
  EXPECT_EQ(plant[NodeId{4}].parent, NodeId{1});
  EXPECT_EQ(edge(plant, 4), EdgeType::branching);
  EXPECT_EQ(plant[NodeId{3}].parent, NodeId{4});
  EXPECT_EQ(plant[NodeId{2}].parent, NodeId{3});
  EXPECT_EQ(edge(plant, 2), EdgeType::successor);
  EXPECT_EQ(plant[NodeId{5}].parent, NodeId{3}) << "what it carries stays where it was";
}

TEST(ReversePath, RefusesNodesBesideEachOther) {
  for (const NodeId bottom : {NodeId{3}, NodeId{2}})
    expectRefused(test::fork(3), "does not carry",
                  [&](SkeletonEditor& editor) { reversePath(editor, NodeId{2}, bottom); });
}

TEST(ReversePath, ReachesAnyDepth) {
  const Skeleton plant = edited(test::stick(100'000), [](SkeletonEditor& editor) {
    reversePath(editor, NodeId{0}, NodeId{99'999});
  });
  EXPECT_THAT(plant.roots(), ElementsAre(NodeId{99'999}));
}

TEST(MergeNodes, PutsOneInTheMiddleOfAChain) {
  Skeleton plant = test::stick(5);
  plant.setRadius(NodeId{1}, 0.4);
  plant.setRadius(NodeId{2}, 0); // not known
  plant.setRadius(NodeId{3}, 0.2);
  plant = edited(plant, [](SkeletonEditor& editor) {
    EXPECT_EQ(mergeNodes(editor, {NodeId{3}, NodeId{1}, NodeId{2}}), NodeId{1});
  });
  EXPECT_THAT(plant.ids(), ElementsAre(NodeId{0}, NodeId{1}, NodeId{4}));
  EXPECT_EQ(plant[NodeId{1}].position, Eigen::Vector3d(0, 0, 2));
  EXPECT_DOUBLE_EQ(plant[NodeId{1}].radius, 0.3);
  EXPECT_EQ(edge(plant, 4), EdgeType::successor);
}

TEST(MergeNodes, CarriesAllThatTheyCarried) {
  const Skeleton plant = edited(test::fork(3), [](SkeletonEditor& editor) {
    mergeNodes(editor, {forkRoot, forkTop});
  });
  EXPECT_THAT(plant.children(forkRoot), ElementsAre(NodeId{2}, NodeId{3}, NodeId{4}));
  EXPECT_EQ(edge(plant, 2), EdgeType::successor);
  EXPECT_EQ(edge(plant, 3), EdgeType::branching);
}

TEST(MergeNodes, JoinsTwoThatStartFromOneNode) { // a branch that was found twice
  Skeleton plant = test::fork(2);
  plant.add({.position = {2, 0, 3}, .parent = NodeId{2}});
  plant.add({.position = {-2, 0, 3}, .parent = NodeId{3}});
  plant = edited(plant, [](SkeletonEditor& editor) {
    EXPECT_EQ(mergeNodes(editor, {NodeId{3}, NodeId{2}}), NodeId{2}) << "which continues";
  });
  EXPECT_THAT(plant.children(forkTop), ElementsAre(NodeId{2}));
  EXPECT_TRUE(plant[NodeId{2}].position.isApprox(Eigen::Vector3d(0, 0, 2)));
  EXPECT_THAT(plant.children(NodeId{2}), ElementsAre(NodeId{4}, NodeId{5}));
  EXPECT_EQ(edge(plant, 5), EdgeType::branching);
}

TEST(MergeNodes, RefusesNodesThatAreNotConnected) {
  const auto merge = [](const std::vector<NodeId>& nodes) {
    return [nodes](SkeletonEditor& editor) { mergeNodes(editor, nodes); };
  };
  expectRefused(test::stick(4), "are not connected", merge({NodeId{0}, NodeId{2}}));
  expectRefused(twoSticks(2, 2), "are not connected", merge({NodeId{0}, NodeId{2}}));
  expectRefused(test::stick(4), "choose two or more", merge({NodeId{1}, NodeId{1}}));
}

// Units of an MTG: of scale 2; nodes are of scale 3.

Entity unit(int index, bool isFirst = true) {
  Entity result{.scale = 2, .symbol = "A", .index = index};
  if (isFirst) result.values = {{"Color", "green"}};
  return result;
}

const Entity own{.scale = 3, .symbol = "E"};

/// 0 < 1 < 2 < 3, with A1 from 0 and A2 from 2.
Skeleton stickOfTwoUnits() {
  Skeleton plant = test::stick(4);
  for (const NodeId id : plant.ids())
    plant.setEntities(id, {own});
  plant.setEntities(NodeId{0}, {unit(1), own});
  plant.setEntities(NodeId{2}, {unit(2), own});
  return plant;
}

TEST(CutOff, LeavesNodesInTheirUnits) {
  const Skeleton plant =
      edited(stickOfTwoUnits(), [](SkeletonEditor& editor) { cutOff(editor, NodeId{3}); });
  EXPECT_EQ(plant[NodeId{3}].entities, (std::vector{unit(2, false), own})) << "a further part";
  const Skeleton atStart =
      edited(stickOfTwoUnits(), [](SkeletonEditor& editor) { cutOff(editor, NodeId{2}); });
  EXPECT_EQ(atStart[NodeId{2}].entities, (std::vector{unit(2), own}));
}

TEST(JoinTree, MakesTheCutPartsOfAUnitOneAgain) {
  const Skeleton plant = edited(stickOfTwoUnits(), [](SkeletonEditor& editor) {
    cutOff(editor, NodeId{3});
    joinTree(editor, NodeId{3}, NodeId{2});
  });
  EXPECT_EQ(plant, stickOfTwoUnits());
}

TEST(Reroot, LetsUnitsStartAtTheirOtherEnd) {
  const Skeleton plant =
      edited(stickOfTwoUnits(), [](SkeletonEditor& editor) { reroot(editor, NodeId{3}); });
  EXPECT_EQ(plant[NodeId{3}].entities, (std::vector{unit(2), own}));
  EXPECT_EQ(plant[NodeId{2}].entities, std::vector{own});
  EXPECT_EQ(plant[NodeId{1}].entities, (std::vector{unit(1), own}));
  EXPECT_EQ(plant[NodeId{0}].entities, std::vector{own});
}

TEST(ReversePath, LeavesAPartOfTheUnitBelowBehind) {
  const Skeleton plant = edited(
      stickOfTwoUnits(), [](SkeletonEditor& editor) { reversePath(editor, NodeId{1}, NodeId{3}); });
  EXPECT_EQ(plant[NodeId{3}].parent, NodeId{0});
  EXPECT_EQ(plant[NodeId{3}].entities, (std::vector{unit(2), own}));
  EXPECT_EQ(plant[NodeId{1}].entities, (std::vector{unit(1, false), own}));
  EXPECT_EQ(plant[NodeId{0}].entities, (std::vector{unit(1), own}));
}

TEST(ReversePath, WithinAUnitTouchesNone) {
  const Skeleton before = stickOfTwoUnits();
  const Skeleton plant =
      edited(before, [](SkeletonEditor& editor) { reversePath(editor, NodeId{0}, NodeId{1}); });
  EXPECT_EQ(plant[NodeId{1}].entities, (std::vector{unit(1), own}));
  EXPECT_EQ(plant[NodeId{0}].entities, std::vector{own});
  EXPECT_EQ(plant[NodeId{2}].entities, before[NodeId{2}].entities);
}

TEST(MergeNodes, LetsTheUnitOfAMergedNodeStartAboveIt) {
  const Skeleton plant = edited(stickOfTwoUnits(), [](SkeletonEditor& editor) {
    mergeNodes(editor, {NodeId{1}, NodeId{2}});
  });
  EXPECT_EQ(plant[NodeId{3}].entities, (std::vector{unit(2), own}));
}

TEST(LikelyNewParent, IsNeitherCarriedNorTheOneBefore) {
  Skeleton plant = test::stick(4); // upward along one line
  const NodeId aside = plant.add({.position = {3, 0, 0}, .parent = NodeId{0}});
  EXPECT_EQ(likelyNewParent(plant, {NodeId{2}}), NodeId{0}) << "1 bears it, it carries 3";
  EXPECT_EQ(likelyNewParent(plant, {NodeId{1}}), aside);
  EXPECT_EQ(likelyNewParent(plant, {NodeId{0}}), std::nullopt) << "it carries all";
  EXPECT_EQ(likelyNewParent(plant, {aside, NodeId{3}}), NodeId{1}) << "of those for both";
}

TEST(LikelyNewParent, LetsTheWoodGoOnWithoutASharpTurn) {
  Skeleton plant = test::stick(2);
  const NodeId foot = plant.add({.position = {1, 0, 1}, .parent = NodeId{0}});
  plant.add({.position = {2, 0, 1}, .parent = foot, .edge = EdgeType::successor});
  plant.add({.position = {1.4, 0, 1.1}, .parent = NodeId{0}}); // nearer, but behind it
  EXPECT_EQ(likelyNewParent(plant, {foot}), NodeId{1});
}

TEST(LikelyNewParent, LetsTheEdgeNotTurnBackAlongWhatBearsIt) {
  Skeleton plant = test::stick(2); // upward
  const NodeId above = plant.add({.position = {0, 0, 2}, .parent = NodeId{1}});
  const NodeId far = plant.add({.position = {9, 0, 0}, .parent = NodeId{0}});
  const NodeId foot = plant.add({.position = {0.5, 0, 1.65}, .parent = far});
  plant.add({.position = {1.5, 0, 1.7}, .parent = foot, .edge = EdgeType::successor});
  ASSERT_LT((plant[above].position - plant[foot].position).norm(), 0.75);
  EXPECT_EQ(likelyNewParent(plant, {foot}), NodeId{1}) << "from above it would lead down again";
}

TEST(LikelyNewParent, MeasuresFromTheSurfaceOfThickWood) {
  Skeleton plant = test::stick(1);
  const NodeId foot = plant.add({.position = {1, 0, 0}, .parent = NodeId{0}});
  const NodeId thin = plant.add({.position = {1, 0.6, 0}, .radius = 0.01, .parent = NodeId{0}});
  const NodeId thick = plant.add({.position = {1, -0.8, 0}, .radius = 0.5, .parent = NodeId{0}});
  EXPECT_EQ(likelyNewParent(plant, {foot}), thick);
  plant.setRadius(thick, 0.01);
  EXPECT_EQ(likelyNewParent(plant, {foot}), thin);
}

} // namespace
} // namespace espalier
