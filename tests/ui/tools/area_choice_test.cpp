#include "tests/support/plants.h"
#include "tests/ui/tools/mouse.h"
#include "tests/ui/tools/quiet_canvas.h"
#include "ui/tools/move_node_tool.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// The default tool where it chooses by area. Pixels are 100 times the places of the mouse.
struct AreaChoiceTest : testing::Test {
  PlantDocument document;
  test::QuietCanvas canvas;
  MoveNodeTool tool{document, canvas};
  test::Mouse mouse{tool};

  void SetUp() override {
    document.openSkeleton(test::fork(3), "fork.mtg");
    canvas.nodes = {NodeId{2}, NodeId{3}};
  }
  [[nodiscard]] const std::vector<NodeId>& chosen() { return document.selection().nodes(); }
};

TEST_F(AreaChoiceTest, ChoosesTheNodesInABoxDrawnWithShift) {
  EXPECT_TRUE(mouse.press({}, {1, 1}, Qt::ShiftModifier)) << "the camera keeps still";
  mouse.drag({2, 3});
  EXPECT_EQ(canvas.band, QPolygonF(QRectF(100, -300, 100, 200)));
  EXPECT_THAT(chosen(), IsEmpty()) << "not before the release";
  mouse.release();
  EXPECT_EQ(canvas.asked, QPolygonF(QRectF(100, -300, 100, 200)));
  EXPECT_TRUE(canvas.band.isEmpty());
  EXPECT_THAT(chosen(), ElementsAre(NodeId{2}, NodeId{3}));
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(AreaChoiceTest, ClosesALassoDrawnWithAlt) {
  mouse.press({}, {0, 0}, Qt::AltModifier);
  mouse.drag({1, 0});
  mouse.drag({1, 1});
  const QPolygonF lasso({QPointF(0, 0), QPointF(100, 0), QPointF(100, -100), QPointF(0, 0)});
  EXPECT_EQ(canvas.band, lasso);
  mouse.release();
  EXPECT_EQ(canvas.asked, lasso);
  EXPECT_THAT(chosen(), ElementsAre(NodeId{2}, NodeId{3}));
}

TEST_F(AreaChoiceTest, AddsWhileShiftIsHeldAtTheEnd) {
  document.selection().set({NodeId{4}, NodeId{3}});
  mouse.press({}, {1, 1}, Qt::ShiftModifier);
  mouse.drag({2, 2});
  mouse.release();
  EXPECT_THAT(chosen(), ElementsAre(NodeId{4}, NodeId{3}, NodeId{2}));
}

TEST_F(AreaChoiceTest, ReplacesWhenShiftWasLetGo) {
  document.selection().set({NodeId{4}});
  mouse.press({}, {1, 1}, Qt::ShiftModifier);
  mouse.drag({2, 2});
  mouse.hold(Qt::NoModifier);
  mouse.release();
  EXPECT_THAT(chosen(), ElementsAre(NodeId{2}, NodeId{3}));
}

TEST_F(AreaChoiceTest, LeavesTheSelectionOnEscape) {
  document.selection().set({NodeId{4}});
  mouse.press({}, {1, 1}, Qt::ShiftModifier);
  mouse.drag({2, 2});
  EXPECT_TRUE(tool.isBusy());
  EXPECT_TRUE(mouse.escape());
  EXPECT_TRUE(canvas.band.isEmpty());
  mouse.drag({3, 3});
  EXPECT_TRUE(canvas.band.isEmpty());
  mouse.release();
  EXPECT_THAT(chosen(), ElementsAre(NodeId{4}));
  EXPECT_FALSE(tool.isBusy());
}

TEST_F(AreaChoiceTest, BeginsABoxOnANodeWithoutMovingIt) {
  mouse.press(test::onNode(NodeId{2}), {1, 2}, Qt::ShiftModifier);
  mouse.drag({2, 2});
  mouse.release();
  EXPECT_EQ(document.skeleton(), test::fork(3));
}

TEST_F(AreaChoiceTest, TakesAShakyShiftClickForAClick) {
  mouse.press(test::onNode(NodeId{4}), {1, 2}, Qt::ShiftModifier);
  mouse.drag({1.01, 2.01});
  EXPECT_TRUE(canvas.band.isEmpty());
  mouse.release();
  EXPECT_THAT(chosen(), ElementsAre(NodeId{4}));
}

TEST_F(AreaChoiceTest, SaysWhatTheReleaseWillDo) {
  mouse.press({}, {1, 1}, Qt::AltModifier);
  mouse.drag({2, 2});
  EXPECT_TRUE(tool.hint().contains("Release: select")) << tool.hint().toStdString();
  EXPECT_TRUE(tool.hint().contains("Esc"));
}

} // namespace
} // namespace espalier
