#include "tests/support/plants.h"
#include "tests/support/random_edits.h"
#include "ui/view/skeleton_glyphs.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

const Eigen::Vector3d origin(10, 20, 30);

SkeletonGlyphs glyphsOf(const Skeleton& plant) {
  SkeletonGlyphs glyphs;
  glyphs.rebuild(plant, origin);
  return glyphs;
}

/// One arbitrary edit.
SkeletonDelta editSomewhere(Skeleton& plant, Random& random) {
  SkeletonEditor editor(plant);
  test::editAtRandom(editor, random);
  return editor.commit();
}

TEST(SkeletonGlyphs, AreTheSameUpdatedAsRebuilt) {
  Skeleton plant = test::randomPlant(60, 5);
  SkeletonGlyphs updated = glyphsOf(plant);
  Random random(11);
  for (int i = 0; i < 400; ++i) {
    const SkeletonDelta delta = editSomewhere(plant, random);
    updated.update(plant, delta);
    const SkeletonGlyphs rebuilt = glyphsOf(plant);
    ASSERT_EQ(updated.nodes(), rebuilt.nodes()) << "after edit " << i;
    ASSERT_EQ(updated.edges(), rebuilt.edges()) << "after edit " << i;
  }
}

TEST(SkeletonGlyphs, ReportTheNodesThatAreMarked) {
  Skeleton plant = test::stick(3);
  SkeletonGlyphs glyphs = glyphsOf(plant);
  SkeletonEditor editor(plant);
  editor.setMarked(NodeId{1}, true);
  glyphs.update(plant, editor.commit());
  EXPECT_FALSE(glyphs.nodes()[0].isUnitStart);
  EXPECT_TRUE(glyphs.nodes()[1].isUnitStart);
}

TEST(SkeletonGlyphs, ChangeOnlyTheSlotsOfTheNodeAndItsChildren) {
  Skeleton plant = test::stick(1000);
  SkeletonGlyphs glyphs = glyphsOf(plant);
  EXPECT_EQ(glyphs.takeChangedNodes().end, 1000U);
  EXPECT_EQ(glyphs.takeChangedEdges().end, 1000U);
  SkeletonEditor editor(plant);
  editor.setPosition(NodeId{500}, {1, 2, 3});
  glyphs.update(plant, editor.commit());
  const SlotRange nodes = glyphs.takeChangedNodes();
  const SlotRange edges = glyphs.takeChangedEdges();
  EXPECT_EQ(nodes.begin, 499U); // its parent's shape depends on it
  EXPECT_EQ(nodes.end, 501U);
  EXPECT_EQ(edges.begin, 500U);
  EXPECT_EQ(edges.end, 502U);
  EXPECT_TRUE(glyphs.takeChangedNodes().isEmpty());
}

TEST(SkeletonGlyphs, DistinguishRootApexAndBranchingNodes) {
  const Skeleton plant = test::fork(2);
  const SkeletonGlyphs glyphs = glyphsOf(plant);
  EXPECT_EQ(glyphs.nodes()[0].shape, NodeShape::root);
  EXPECT_EQ(glyphs.nodes()[1].shape, NodeShape::branching);
  EXPECT_EQ(glyphs.nodes()[2].shape, NodeShape::apex);
  EXPECT_EQ(glyphs.edges()[0].shape, EdgeShape::none);
  EXPECT_EQ(glyphs.edges()[1].shape, EdgeShape::successor);
  EXPECT_EQ(glyphs.edges()[3].shape, EdgeShape::branching);
}

TEST(SkeletonGlyphs, AreMarkedWhileSelectedOrHovered) {
  SkeletonGlyphs glyphs = glyphsOf(test::stick(4));
  glyphs.select({NodeId{1}, NodeId{2}, NodeId{99}});
  Pick pick;
  pick.node = NodeId{2};
  EXPECT_TRUE(glyphs.hover(pick));
  EXPECT_FALSE(glyphs.hover(pick));
  EXPECT_EQ(glyphs.nodes()[1].mark, Mark::selected);
  EXPECT_EQ(glyphs.nodes()[2].mark, Mark::both);
  glyphs.hover({});
  EXPECT_EQ(glyphs.nodes()[2].mark, Mark::selected);
  pick.node = NodeId{3};
  glyphs.hover(pick);
  EXPECT_EQ(glyphs.nodes()[3].mark, Mark::hovered);
  glyphs.hover({});
  glyphs.select({NodeId{3}});
  EXPECT_EQ(glyphs.nodes()[1].mark, Mark::none);
  EXPECT_EQ(glyphs.nodes()[3].mark, Mark::selected);
}

TEST(SkeletonGlyphs, ShowTheHoveredEdge) {
  SkeletonGlyphs glyphs = glyphsOf(test::stick(4));
  Pick pick;
  pick.edge = EdgePick{NodeId{2}, 0.5, {0, 0, 1.5}};
  EXPECT_TRUE(glyphs.hover(pick));
  EXPECT_EQ(glyphs.edges()[2].mark, Mark::hovered);
  EXPECT_TRUE(glyphs.hover({}));
  EXPECT_EQ(glyphs.edges()[2].mark, Mark::none);
}

TEST(SkeletonGlyphs, KeepTheSelectionThroughEdits) {
  Skeleton plant = test::stick(4);
  SkeletonGlyphs glyphs = glyphsOf(plant);
  glyphs.select({NodeId{2}, NodeId{3}});
  SkeletonEditor editor(plant);
  editor.setPosition(NodeId{2}, {5, 5, 5});
  editor.erase(NodeId{3});
  glyphs.update(plant, editor.commit());
  EXPECT_EQ(glyphs.nodes()[2].mark, Mark::selected);
  EXPECT_EQ(glyphs.nodes()[3].mark, Mark::none);
}

TEST(SkeletonGlyphs, KnowTheTypicalLengthOfAPlantThatAnEditMade) {
  Skeleton plant;
  SkeletonGlyphs glyphs = glyphsOf(plant);
  SkeletonEditor editor(plant);
  for (std::uint32_t i = 0; i < 9; ++i) {
    Node node{.position = {0, 0, 0.25 * i}};
    if (i > 0) node.parent = NodeId{i - 1};
    editor.add(node);
  }
  glyphs.update(plant, editor.commit());
  EXPECT_NEAR(glyphs.typicalLength(), 0.25, 1e-6);
}

TEST(SkeletonGlyphs, StayInPlaceWhenTheirOriginMoves) {
  const Skeleton plant = test::randomPlant(20, 2);
  SkeletonGlyphs glyphs = glyphsOf(plant);
  glyphs.moveOrigin({-3, 1, 4});
  for (const NodeId id : plant.ids())
    EXPECT_LT((glyphs.position(indexOf(id)) - plant[id].position).norm(), 1e-5);
}

TEST(SkeletonGlyphs, AreNoneForAnEmptySkeleton) {
  const SkeletonGlyphs glyphs = glyphsOf(Skeleton());
  EXPECT_TRUE(glyphs.nodes().empty());
  EXPECT_TRUE(glyphs.bounds().isEmpty());
  EXPECT_EQ(glyphs.typicalLength(), 0);
}

} // namespace
} // namespace espalier
