#include "core/base/error.h"
#include "core/skeleton/branch_edits.h"
#include "tests/support/plants.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

const std::vector<Eigen::Vector3d> places = {{1, 0, 0}, {2, 0, 0}};

/// Runs an edit, and expects that undo gives the plant before.
template <class Change> Skeleton edited(const Skeleton& plant, const Change& change) {
  Skeleton after = plant;
  SkeletonEditor editor(after);
  change(editor);
  const SkeletonDelta delta = editor.commit();
  Skeleton back = after;
  delta.inverse().apply(back);
  EXPECT_EQ(back, plant);
  return after;
}

TEST(AddBranch, ContinuesAnAxisAtItsApex) {
  const Skeleton plant = edited(test::stick(2), [](SkeletonEditor& editor) {
    EXPECT_EQ(addBranch(editor, NodeId{1}, places, {0.05, 0.2}), NodeId{3});
  });
  EXPECT_EQ(plant[NodeId{2}].edge, EdgeType::successor);
  EXPECT_EQ(plant[NodeId{2}].parent, NodeId{1});
  EXPECT_EQ(plant[NodeId{3}].position, places[1]);
  EXPECT_EQ(plant[NodeId{2}].radius, 0.05);
  EXPECT_EQ(plant[NodeId{3}].radius, 0.1); // not thicker than what bears it
}

TEST(AddBranch, BranchesWhereTheAxisGoesOn) {
  const Skeleton plant = edited(test::stick(3), [](SkeletonEditor& editor) {
    addBranch(editor, NodeId{1}, places, {0, 0});
  });
  EXPECT_EQ(plant[NodeId{3}].edge, EdgeType::branching);
  EXPECT_EQ(plant[NodeId{4}].edge, EdgeType::successor);
  EXPECT_EQ(plant[NodeId{4}].radius, 0.1); // where none was measured
}

TEST(AddBranch, MakesATreeOfItsOwn) {
  const Skeleton plant = edited(test::stick(1), [](SkeletonEditor& editor) {
    addBranch(editor, std::nullopt, places, {0.3, 0});
  });
  EXPECT_EQ(plant.roots(), (std::vector<NodeId>{NodeId{0}, NodeId{1}}));
  EXPECT_EQ(plant[NodeId{2}].radius, 0.3);
}

TEST(ReplaceCarried, LeavesTheNodeAndTheRest) {
  const Skeleton before = test::fork(3);
  const Skeleton part = test::stick(3);
  const Skeleton plant =
      edited(before, [&](SkeletonEditor& editor) { replaceCarried(editor, test::forkTop, part); });
  ASSERT_EQ(plant.size(), 4U);
  EXPECT_EQ(plant[test::forkRoot], before[test::forkRoot]);
  EXPECT_EQ(plant[test::forkTop], before[test::forkTop]);
  const NodeId child = plant.children(test::forkTop).front();
  EXPECT_EQ(plant[child].position, part[NodeId{1}].position);
  EXPECT_EQ(plant[plant.children(child).front()].position, part[NodeId{2}].position);
}

/// Two stems side by side, each of three nodes: 0 1 2 and 3 4 5.
Skeleton twoStems() {
  Skeleton plant = test::stick(3);
  const NodeId root = plant.add({.position = {1, 0, 0}});
  const NodeId middle = plant.add({.position = {1, 0, 1}, .parent = root});
  plant.add({.position = {1, 0, 2}, .parent = middle, .edge = EdgeType::branching});
  return plant;
}

TEST(AddCarried, AttachesAllOfAPartBesideWhatIsThere) {
  Skeleton plant = test::fork(2); // its top carries a successor and a branch
  const Skeleton before = plant;
  SkeletonEditor editor(plant);
  const std::vector<NodeId> first = addCarried(editor, test::forkTop, test::stick(3));
  (void)editor.commit();
  ASSERT_EQ(first.size(), 1U);
  EXPECT_EQ(plant.size(), before.size() + 2);
  EXPECT_EQ(plant[first[0]].parent, test::forkTop);
  EXPECT_EQ(plant[first[0]].edge, EdgeType::branching) << "another one goes on with the axis";
  EXPECT_EQ(plant[first[0]].position, Eigen::Vector3d(0, 0, 1));
  ASSERT_EQ(plant.children(first[0]).size(), 1U);
  EXPECT_EQ(plant[plant.children(first[0])[0]].edge, EdgeType::successor);
  for (const NodeId id : before.ids())
    EXPECT_EQ(plant[id], before[id]);
}

TEST(AddCarried, GoesOnWithAnAxisThatEnds) {
  Skeleton plant = test::stick(2);
  SkeletonEditor editor(plant);
  const std::vector<NodeId> first = addCarried(editor, NodeId{1}, test::fork(1));
  (void)editor.commit();
  EXPECT_EQ(plant[first[0]].edge, EdgeType::successor);
}

TEST(ExchangeArms, SwapsParentsAndEdges) {
  const Skeleton plant = edited(
      twoStems(), [](SkeletonEditor& editor) { exchangeArms(editor, NodeId{2}, NodeId{5}); });
  EXPECT_EQ(plant[NodeId{2}].parent, NodeId{4});
  EXPECT_EQ(plant[NodeId{2}].edge, EdgeType::branching);
  EXPECT_EQ(plant[NodeId{5}].parent, NodeId{1});
  EXPECT_EQ(plant[NodeId{5}].edge, EdgeType::successor);
}

TEST(ExchangeArms, TwiceIsAsBefore) {
  const Skeleton before = twoStems();
  Skeleton plant = before;
  SkeletonEditor editor(plant);
  exchangeArms(editor, NodeId{1}, NodeId{5});
  exchangeArms(editor, NodeId{1}, NodeId{5});
  EXPECT_TRUE(editor.commit().isEmpty());
  EXPECT_EQ(plant, before);
}

TEST(ExchangeArms, IsRefusedWithoutACrossing) {
  Skeleton plant = test::fork(2);
  SkeletonEditor editor(plant);
  const NodeId shoot = editor.skeleton().children(test::forkTop).front();
  const NodeId other = editor.skeleton().children(test::forkTop).back();
  EXPECT_THROW(exchangeArms(editor, test::forkRoot, shoot), Error);
  EXPECT_THROW(exchangeArms(editor, test::forkTop, shoot), Error);
  EXPECT_THROW(exchangeArms(editor, shoot, other), Error);
  EXPECT_TRUE(editor.commit().isEmpty());
}

} // namespace
} // namespace espalier
