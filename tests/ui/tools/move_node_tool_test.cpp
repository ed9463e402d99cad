#include "tests/support/plants.h"
#include "tests/ui/tools/mouse.h"
#include "tests/ui/tools/quiet_canvas.h"
#include "ui/tools/move_node_tool.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using test::forkTop;
using test::onEdge;
using test::onNode;
using testing::ElementsAre;

struct MoveNodeToolTest : testing::Test {
  PlantDocument document;
  test::QuietCanvas canvas;
  MoveNodeTool tool{document, canvas};
  test::Mouse mouse{tool};

  void SetUp() override { document.openSkeleton(test::fork(3), "fork.mtg"); }
  [[nodiscard]] const std::vector<NodeId>& chosen() { return document.selection().nodes(); }
};

TEST_F(MoveNodeToolTest, ChoosesTheNodeClicked) {
  EXPECT_TRUE(mouse.click(onNode(NodeId{2}), {1, 2}));
  EXPECT_THAT(chosen(), ElementsAre(NodeId{2}));
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(MoveNodeToolTest, AddsAndRemovesWithShift) {
  mouse.click(onNode(NodeId{2}), {1, 2});
  mouse.click(onNode(NodeId{3}), {0, 2}, Qt::ShiftModifier);
  EXPECT_THAT(chosen(), ElementsAre(NodeId{2}, NodeId{3}));
  mouse.click(onNode(NodeId{2}), {1, 2}, Qt::ShiftModifier);
  EXPECT_THAT(chosen(), ElementsAre(NodeId{3}));
}

TEST_F(MoveNodeToolTest, ChoosesTheNodeThatAnEdgeLeadsTo) {
  mouse.click(onEdge(document.skeleton(), NodeId{3}, 0.5), {0, 1.5});
  EXPECT_THAT(chosen(), ElementsAre(NodeId{3}));
}

TEST_F(MoveNodeToolTest, ChoosesNothingByAClickOnNothing) {
  mouse.click(onNode(NodeId{2}), {1, 2});
  EXPECT_FALSE(mouse.click({}, {5, 5}));
  EXPECT_TRUE(chosen().empty());
}

TEST_F(MoveNodeToolTest, LeavesADragOnNothingToTheCamera) {
  mouse.click(onNode(NodeId{2}), {1, 2});
  EXPECT_FALSE(mouse.press({}, {5, 5}));
  EXPECT_FALSE(mouse.drag({5.5, 5}));
  EXPECT_FALSE(mouse.drag({5, 5})); // back where it was pressed: still no click
  EXPECT_FALSE(mouse.release());
  EXPECT_THAT(chosen(), ElementsAre(NodeId{2}));
}

TEST_F(MoveNodeToolTest, TurnsTheViewOverANodeWithControl) {
  EXPECT_FALSE(mouse.press(onNode(NodeId{2}), {1, 2}, Qt::ControlModifier));
  mouse.drag({2, 2});
  mouse.release();
  EXPECT_EQ(document.skeleton(), test::fork(3));
}

TEST_F(MoveNodeToolTest, LeavesTheOtherButtonsToTheCamera) {
  EXPECT_FALSE(mouse.press(onNode(NodeId{2}), {1, 2}, Qt::NoModifier, Qt::RightButton));
  EXPECT_TRUE(chosen().empty());
}

TEST_F(MoveNodeToolTest, DragsANodeInThePlaneOfTheScreen) {
  mouse.press(onNode(NodeId{2}), {1.02, 2.01}); // beside the middle of the node
  mouse.drag({1.3, 2});
  mouse.drag({1.52, 2.41});
  mouse.release();
  EXPECT_TRUE(document.skeleton()[NodeId{2}].position.isApprox(Eigen::Vector3d(1.5, 0, 2.4)));
  EXPECT_EQ(document.undoStack().count(), 1);
  EXPECT_EQ(document.undoStack().undoText(), "Move node 2");
  const Skeleton moved = document.skeleton();
  document.undoStack().undo();
  EXPECT_EQ(document.skeleton(), test::fork(3));
  document.undoStack().redo();
  EXPECT_EQ(document.skeleton(), moved);
}

TEST_F(MoveNodeToolTest, IgnoresAShakyHand) {
  mouse.press(onNode(NodeId{2}), {1, 2});
  mouse.drag({1.01, 2.01});
  mouse.release();
  EXPECT_EQ(document.skeleton(), test::fork(3));
  EXPECT_FALSE(document.isModified());
}

TEST_F(MoveNodeToolTest, DragsAllChosenNodes) {
  document.selection().set({NodeId{2}, NodeId{4}});
  mouse.press(onNode(NodeId{4}), {0, 2});
  mouse.drag({1, 2});
  mouse.release();
  EXPECT_TRUE(document.skeleton()[NodeId{2}].position.isApprox(Eigen::Vector3d(2, 0, 2)));
  EXPECT_EQ(document.undoStack().undoText(), "Move 2 nodes");
  EXPECT_EQ(document.skeleton()[NodeId{3}], test::fork(3)[NodeId{3}]);
}

TEST_F(MoveNodeToolTest, DragsOnlyTheNodePressedIfItWasNotChosen) {
  document.selection().set({NodeId{3}, NodeId{4}});
  mouse.press(onNode(NodeId{2}), {1, 2});
  mouse.drag({2, 2});
  mouse.release();
  EXPECT_EQ(document.undoStack().undoText(), "Move node 2");
}

TEST_F(MoveNodeToolTest, PutsTheNodeBackOnEscape) {
  mouse.press(onNode(NodeId{2}), {1, 2});
  mouse.drag({2, 2});
  EXPECT_TRUE(mouse.escape());
  EXPECT_EQ(document.skeleton(), test::fork(3));
  EXPECT_TRUE(mouse.drag({3, 2})) << "the camera keeps still until the release";
  mouse.release();
  EXPECT_EQ(document.skeleton(), test::fork(3));
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(MoveNodeToolTest, SaysWhatTheMouseWillDo) {
  mouse.hover({}, {5, 5});
  EXPECT_TRUE(tool.hint().contains("Drag: turn"));
  mouse.hover(onNode(forkTop), {0, 1});
  EXPECT_TRUE(tool.hint().contains("Click: select node 1"));
  mouse.press(onNode(forkTop), {0, 1});
  mouse.drag({1, 1});
  EXPECT_TRUE(tool.hint().contains("Esc: put it back"));
}

} // namespace
} // namespace espalier
