#include "core/base/error.h"
#include "core/skeleton/edits.h"
#include "tests/core/skeleton/edited.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

#include <functional>
#include <gmock/gmock.h>

namespace espalier {
namespace {

using test::edited;
using test::forkRoot;
using test::forkTop;
using testing::ElementsAre;

SkeletonDelta edit(Skeleton& plant, const std::function<void(SkeletonEditor&)>& change) {
  SkeletonEditor editor(plant);
  change(editor);
  return editor.commit();
}

TEST(AddChild, ContinuesAnApexAndBranchesElsewhere) {
  Skeleton plant = test::stick(2);
  edit(plant, [](SkeletonEditor& editor) {
    addChild(editor, NodeId{1}, {0, 0, 2});
    addChild(editor, NodeId{1}, {1, 0, 2});
  });
  EXPECT_EQ(plant[NodeId{2}].edge, EdgeType::successor);
  EXPECT_EQ(plant[NodeId{3}].edge, EdgeType::branching);
  EXPECT_DOUBLE_EQ(plant[NodeId{3}].radius, 0.1);
}

TEST(SplitEdge, PutsANodeOnTheEdge) {
  Skeleton plant = test::fork(2);
  plant.setRadius(NodeId{3}, 0.02);
  edit(plant, [](SkeletonEditor& editor) { splitEdge(editor, NodeId{3}, 0.25); });
  const Node& added = plant[NodeId{4}];
  EXPECT_TRUE(added.position.isApprox(Eigen::Vector3d(-0.25, 0, 1.25)));
  EXPECT_DOUBLE_EQ(added.radius, 0.08);
  EXPECT_EQ(added.parent, forkTop);
  EXPECT_EQ(added.edge, EdgeType::branching);
  EXPECT_EQ(plant[NodeId{3}].parent, NodeId{4});
  EXPECT_EQ(plant[NodeId{3}].edge, EdgeType::successor);
}

TEST(SplitEdge, RefusesARoot) {
  Skeleton plant = test::stick(2);
  EXPECT_THROW(edit(plant, [](SkeletonEditor& editor) { splitEdge(editor, NodeId{0}, 0.5); }),
               Error);
}

TEST(RemoveNode, KeepsAnAxisInOnePiece) {
  Skeleton plant = test::fork(3);
  edit(plant, [](SkeletonEditor& editor) { removeNode(editor, forkTop); });
  EXPECT_THAT(plant.children(forkRoot), ElementsAre(NodeId{2}, NodeId{3}, NodeId{4}));
  EXPECT_EQ(plant[NodeId{2}].edge, EdgeType::successor);
  EXPECT_EQ(plant[NodeId{3}].edge, EdgeType::branching);
}

TEST(RemoveNode, KeepsABranchABranch) {
  Skeleton plant = test::fork(2);
  plant.add({.parent = NodeId{3}});
  edit(plant, [](SkeletonEditor& editor) { removeNode(editor, NodeId{3}); });
  EXPECT_EQ(plant[NodeId{4}].parent, forkTop);
  EXPECT_EQ(plant[NodeId{4}].edge, EdgeType::branching);
}

TEST(RemoveNode, MakesTheSuccessorOfARootTheRoot) {
  Skeleton plant = test::fork(2);
  plant.add({.parent = forkRoot, .edge = EdgeType::branching});
  edit(plant, [](SkeletonEditor& editor) { removeNode(editor, forkRoot); });
  EXPECT_THAT(plant.roots(), ElementsAre(forkTop));
  EXPECT_EQ(plant[NodeId{4}].parent, forkTop);
  EXPECT_EQ(plant[NodeId{4}].edge, EdgeType::branching);
}

TEST(RemoveNode, MakesTheOnlyChildOfARootTheRoot) {
  Skeleton plant = test::stick(2);
  plant.setEdge(NodeId{1}, EdgeType::branching);
  edit(plant, [](SkeletonEditor& editor) { removeNode(editor, NodeId{0}); });
  EXPECT_THAT(plant.roots(), ElementsAre(NodeId{1}));
}

TEST(RemoveNode, MakesNoTrunkOutOfABranch) {
  Skeleton plant = test::stick(1);
  plant.add({.parent = NodeId{0}, .edge = EdgeType::branching});
  plant.add({.parent = NodeId{0}, .edge = EdgeType::branching});
  edit(plant, [](SkeletonEditor& editor) { removeNode(editor, NodeId{0}); });
  EXPECT_THAT(plant.roots(), ElementsAre(NodeId{1}, NodeId{2}));
}

TEST(RemoveNode, TakesTheLastNode) {
  Skeleton plant = test::stick(1);
  edit(plant, [](SkeletonEditor& editor) { removeNode(editor, NodeId{0}); });
  EXPECT_TRUE(plant.isEmpty());
}

TEST(RemoveSubtree, TakesAllThatANodeCarries) {
  Skeleton plant = test::fork(3);
  edit(plant, [](SkeletonEditor& editor) { removeSubtree(editor, forkTop); });
  EXPECT_THAT(plant.ids(), ElementsAre(forkRoot));
}

TEST(RemoveSubtree, ReachesAnyDepth) {
  Skeleton plant = test::stick(200'000);
  edit(plant, [](SkeletonEditor& editor) { removeSubtree(editor, NodeId{1}); });
  EXPECT_EQ(plant.size(), 1U);
}

TEST(ReparentNode, ContinuesAnApexAndBranchesElsewhere) {
  Skeleton plant = test::fork(3);
  edit(plant, [](SkeletonEditor& editor) { reparentNode(editor, NodeId{3}, NodeId{4}); });
  EXPECT_EQ(plant[NodeId{3}].edge, EdgeType::successor);
  edit(plant, [](SkeletonEditor& editor) { reparentNode(editor, NodeId{2}, NodeId{4}); });
  EXPECT_EQ(plant[NodeId{2}].edge, EdgeType::branching);
}

TEST(ReparentNode, ChangesNothingWhereItIsAttachedAlready) {
  Skeleton plant = test::fork(3);
  EXPECT_TRUE(edit(plant, [](SkeletonEditor& editor) {
                reparentNode(editor, NodeId{3}, forkTop);
              }).isEmpty());
}

TEST(ReparentNode, RefusesADescendantAndSaysWhy) {
  Skeleton plant = test::fork(3);
  const auto onItsTwig = [](SkeletonEditor& editor) { reparentNode(editor, forkTop, NodeId{2}); };
  EXPECT_THAT([&] { edit(plant, onItsTwig); },
              testing::ThrowsMessage<Error>(testing::HasSubstr("node 1 to node 2")));
  EXPECT_EQ(plant, test::fork(3));
}

TEST(ReparentNode, JoinsTwoTrees) {
  Skeleton plant = test::stick(2);
  plant.add({.position = {0, 0, 2}});
  edit(plant, [](SkeletonEditor& editor) { reparentNode(editor, NodeId{2}, NodeId{1}); });
  EXPECT_THAT(plant.roots(), ElementsAre(NodeId{0}));
  EXPECT_EQ(plant[NodeId{2}].edge, EdgeType::successor);
}

// What an MTG says of the nodes: units of scale 2 start at nodes, which are of scale 3.

Entity unitNamed(int index, const std::string& color = {}) {
  Entity unit{.scale = 2, .symbol = "A", .index = index};
  if (!color.empty()) unit.values = {{"Color", color}};
  return unit;
}

Entity ownNamed(int index) {
  return {.scale = 3, .symbol = "E", .index = index};
}

/// 0 < 1 < 2 in A1, which starts at 0; on 1 branches 3, where A2 starts; 3 < 4 and 3 + 5 in A2.
Skeleton twoUnits() {
  Skeleton plant;
  const auto add = [&](std::optional<NodeId> parent, EdgeType edge) {
    const int index = static_cast<int>(plant.size());
    const NodeId id = plant.add({.position = {0, 0, 1.0 * index}, .parent = parent, .edge = edge});
    plant.setEntities(id, {ownNamed(index)});
    return id;
  };
  const NodeId root = add(std::nullopt, EdgeType::successor);
  const NodeId fork = add(root, EdgeType::successor);
  add(fork, EdgeType::successor);
  const NodeId branch = add(fork, EdgeType::branching);
  add(branch, EdgeType::successor);
  add(branch, EdgeType::branching);
  plant.setEntities(root, {unitNamed(1, "brown"), ownNamed(0)});
  plant.setEntities(branch, {unitNamed(2, "green"), ownNamed(3)});
  return plant;
}

TEST(Units, StartAtTheNodeThatSplitsTheEdgeTheyStartedAt) {
  const Skeleton plant = twoUnits();
  const Skeleton result =
      edited(plant, [](SkeletonEditor& editor) { splitEdge(editor, NodeId{3}, 0.5); });
  const Entity unnamed{.scale = 3, .symbol = "E"};
  EXPECT_EQ(result[NodeId{6}].entities, (std::vector{unitNamed(2, "green"), unnamed}));
  EXPECT_EQ(result[NodeId{3}].entities, std::vector{ownNamed(3)});
}

TEST(Units, AreJoinedByANodeThatSplitsAnEdgeWithinThem) {
  const Skeleton plant = twoUnits();
  const Skeleton result =
      edited(plant, [](SkeletonEditor& editor) { splitEdge(editor, NodeId{2}, 0.5); });
  EXPECT_TRUE(result[NodeId{6}].entities.empty());
  EXPECT_EQ(result[NodeId{2}].entities, plant[NodeId{2}].entities);
}

TEST(Units, GoOnInEachPartThatARemovedNodeJoined) {
  const Skeleton result =
      edited(twoUnits(), [](SkeletonEditor& editor) { removeNode(editor, NodeId{3}); });
  EXPECT_EQ(result[NodeId{4}].entities, (std::vector{unitNamed(2, "green"), ownNamed(4)}));
  EXPECT_EQ(result[NodeId{5}].entities, (std::vector{unitNamed(2), ownNamed(5)}))
      << "values are stated once";
  EXPECT_EQ(result[NodeId{2}].entities, twoUnits()[NodeId{2}].entities);
}

TEST(Units, GoOnAtAChildThatSaidNothingOfItself) {
  Skeleton plant = twoUnits();
  plant.setEntities(NodeId{4}, {});
  const Skeleton result =
      edited(plant, [](SkeletonEditor& editor) { removeNode(editor, NodeId{3}); });
  const Entity unnamed{.scale = 3, .symbol = "E"};
  EXPECT_EQ(result[NodeId{4}].entities, (std::vector{unitNamed(2, "green"), unnamed}));
}

TEST(Units, AreNotPassedOnToAChildThatStartsAnother) {
  Skeleton plant = twoUnits();
  plant.setEntities(NodeId{4}, {unitNamed(3), ownNamed(4)});
  const Skeleton result =
      edited(plant, [](SkeletonEditor& editor) { removeNode(editor, NodeId{3}); });
  EXPECT_EQ(result[NodeId{4}].entities, plant[NodeId{4}].entities);
  EXPECT_EQ(result[NodeId{5}].entities, (std::vector{unitNamed(2, "green"), ownNamed(5)}));
}

TEST(Units, GoOnAtTheNewRootWhichCarriesTheOthers) {
  const Skeleton below =
      edited(twoUnits(), [](SkeletonEditor& editor) { removeNode(editor, NodeId{0}); });
  EXPECT_EQ(below[NodeId{1}].entities, (std::vector{unitNamed(1, "brown"), ownNamed(1)}));
  const Skeleton next =
      edited(below, [](SkeletonEditor& editor) { removeNode(editor, NodeId{1}); });
  EXPECT_EQ(next[NodeId{2}].entities, (std::vector{unitNamed(1, "brown"), ownNamed(2)}));
  EXPECT_EQ(next[NodeId{3}].entities, twoUnits()[NodeId{3}].entities) << "another unit";
  EXPECT_EQ(next[NodeId{3}].parent, NodeId{2});
}

TEST(Units, GoWithTheirLastNode) {
  const Skeleton result = edited(twoUnits(), [](SkeletonEditor& editor) {
    for (const NodeId id : {NodeId{4}, NodeId{5}, NodeId{3}})
      removeNode(editor, id);
  });
  for (const NodeId id : {NodeId{0}, NodeId{1}, NodeId{2}})
    EXPECT_EQ(result[id].entities, twoUnits()[id].entities);
}

TEST(Units, StayAsTheyAreWhereASubtreeIsRemoved) {
  const Skeleton result =
      edited(twoUnits(), [](SkeletonEditor& editor) { removeSubtree(editor, NodeId{3}); });
  ASSERT_EQ(result.size(), 3U);
  for (const NodeId id : result.ids())
    EXPECT_EQ(result[id].entities, twoUnits()[id].entities);
}

TEST(Units, GoWithTheNodeThatIsReparented) {
  const Skeleton plant = twoUnits();
  const Skeleton result =
      edited(plant, [](SkeletonEditor& editor) { reparentNode(editor, NodeId{3}, NodeId{2}); });
  ASSERT_EQ(result[NodeId{3}].parent, NodeId{2});
  for (const NodeId id : plant.ids())
    EXPECT_EQ(result[id].entities, plant[id].entities);
}

TEST(SetEdgeType, DemotesTheSiblingOfANewSuccessor) {
  Skeleton plant = test::fork(3);
  edit(plant, [](SkeletonEditor& editor) { setEdgeType(editor, NodeId{4}, EdgeType::successor); });
  EXPECT_EQ(plant[NodeId{4}].edge, EdgeType::successor);
  EXPECT_EQ(plant[NodeId{2}].edge, EdgeType::branching);
}

TEST(SetEdgeType, RefusesARoot) {
  Skeleton plant = test::stick(2);
  EXPECT_THROW(
      edit(plant,
           [](SkeletonEditor& editor) { setEdgeType(editor, NodeId{0}, EdgeType::branching); }),
      Error);
}

TEST(ReplaceSkeleton, CopiesIntoAnEmptyOneUnderTheSameIds) {
  const Skeleton plant = test::randomPlant(200, 1);
  Skeleton copy;
  edit(copy, [&](SkeletonEditor& editor) { replaceSkeleton(editor, plant); });
  EXPECT_EQ(copy, plant);
}

TEST(ReplaceSkeleton, CopiesNodesThatComeBeforeTheirParents) {
  Skeleton plant = test::stick(3);
  plant.makeRoot(NodeId{1});
  plant.reparent(NodeId{0}, NodeId{2}, EdgeType::branching);
  Skeleton copy;
  edit(copy, [&](SkeletonEditor& editor) { replaceSkeleton(editor, plant); });
  EXPECT_EQ(copy, plant);
}

TEST(ReplaceSkeleton, IsTakenBackAsOneEdit) {
  Skeleton plant = test::randomPlant(100, 2);
  const Skeleton before = plant;
  const SkeletonDelta delta =
      edit(plant, [](SkeletonEditor& editor) { replaceSkeleton(editor, test::fork(3)); });
  EXPECT_EQ(plant.size(), 5U);
  EXPECT_FALSE(plant.contains(NodeId{0})) << "ids are never handed out twice";
  delta.inverse().apply(plant);
  EXPECT_EQ(plant, before);
}

} // namespace
} // namespace espalier
