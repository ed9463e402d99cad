#include "core/skeleton/edits.h"
#include "tests/support/plants.h"
#include "tests/ui/tools/mouse.h"
#include "tests/ui/tools/quiet_canvas.h"
#include "ui/tools/measure_tool.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

using test::forkRoot;
using test::forkTop;
using test::onEdge;
using test::onNode;
using test::onPoint;

struct MeasureToolTest : testing::Test {
  PlantDocument document;
  test::QuietCanvas canvas;
  MeasureTool tool{document, canvas};
  test::Mouse mouse{tool};
  std::vector<NodeId> shoots;

  void SetUp() override {
    document.openSkeleton(test::fork(2), "fork.mtg");
    document.setUnit(LengthUnit::meter);
    shoots = document.skeleton().children(forkTop); // opposite each other, 45 degrees off
  }
  void click(const Pick& pick) { mouse.click(pick, {0, 0}); }
};

constexpr auto nothing = "";

TEST_F(MeasureToolTest, ShowsTheLengthStraightAndAlongThePlant) {
  click(onNode(shoots[0]));
  EXPECT_EQ(tool.result(), nothing);
  click(onNode(shoots[1]));
  EXPECT_EQ(tool.result(), "straight 2.000\u202fm   along the plant 2.828\u202fm");
  EXPECT_TRUE(tool.hint().contains(tool.result()));
  ASSERT_EQ(canvas.preview.lines.size(), 1U);
  EXPECT_TRUE(canvas.preview.lines[0][0].isApprox(document.skeleton()[shoots[0]].position));
  EXPECT_EQ(canvas.preview.label, "straight 2.000\u202fm · along the plant 2.828\u202fm");
}

TEST_F(MeasureToolTest, ShowsTheAngleAtTheSecondOfThree) {
  click(onNode(shoots[0]));
  click(onNode(forkTop));
  click(onNode(shoots[1]));
  EXPECT_EQ(tool.result(), "angle 90.0°   1.414\u202fm   1.414\u202fm");
  ASSERT_EQ(canvas.preview.lines.size(), 1U);
  EXPECT_EQ(canvas.preview.lines[0].size(), 3U);
  click(onNode(forkRoot));
  EXPECT_EQ(tool.result(), nothing) << "the fourth begins anew";
  EXPECT_EQ(canvas.preview.nodes.size(), 1U);
}

TEST_F(MeasureToolTest, MeasuresFromPlacesOnEdges) {
  click(onEdge(document.skeleton(), forkTop, 0.25));
  click(onNode(forkTop));
  EXPECT_EQ(tool.result(), "straight 0.7500\u202fm   along the plant 0.7500\u202fm");
}

TEST_F(MeasureToolTest, MeasuresStraightToPoints) {
  click(onPoint({3, 0, 1}));
  click(onNode(forkTop));
  EXPECT_EQ(tool.result(), "straight 3.000\u202fm");
}

TEST_F(MeasureToolTest, SaysThatThereIsNoPathToAnotherTree) {
  NodeId other{};
  document.edit("Add", [&](SkeletonEditor& editor) {
    other = editor.add({.position = {0, 0, 5}});
  });
  click(onNode(forkTop));
  click(onNode(other));
  EXPECT_EQ(tool.result(), "straight 4.000\u202fm   in different trees");
}

TEST_F(MeasureToolTest, ShowsThePathToThePointerBeforeTheSecondClick) {
  click(onNode(forkRoot));
  mouse.hover(onNode(forkTop), {0, 1});
  EXPECT_TRUE(canvas.preview.label.startsWith("straight 1.000"));
  EXPECT_EQ(tool.result(), nothing);
  mouse.hover({}, {5, 5});
  EXPECT_TRUE(canvas.preview.lines.empty());
}

TEST_F(MeasureToolTest, LeavesDragsAndEmptySpaceToTheCamera) {
  EXPECT_FALSE(mouse.press(onNode(forkTop), {0, 1}));
  EXPECT_FALSE(mouse.drag({1, 1}));
  mouse.release(onNode(forkTop));
  click({});
  EXPECT_FALSE(tool.isBusy());
  EXPECT_TRUE(canvas.preview.isEmpty());
}

TEST_F(MeasureToolTest, IsClearedByEscapeAtAnyTime) {
  click(onNode(forkTop));
  EXPECT_TRUE(tool.isBusy());
  mouse.escape();
  EXPECT_FALSE(tool.isBusy());
  click(onNode(forkTop));
  click(onNode(forkRoot));
  mouse.escape();
  EXPECT_EQ(tool.result(), nothing);
  EXPECT_TRUE(canvas.preview.isEmpty());
}

TEST_F(MeasureToolTest, FollowsThePlantAndGoesWithItsNodes) {
  click(onNode(forkRoot));
  click(onNode(forkTop));
  const auto setHeight = [&](double z) {
    document.edit("Move", [=](SkeletonEditor& editor) { moveNode(editor, forkTop, {0, 0, z}); });
  };
  setHeight(3);
  EXPECT_EQ(tool.result(), "straight 3.000\u202fm   along the plant 3.000\u202fm");
  document.edit("Remove", [](SkeletonEditor& editor) { removeNode(editor, forkTop); });
  EXPECT_EQ(tool.result(), nothing);
  EXPECT_TRUE(canvas.preview.isEmpty());
}

TEST_F(MeasureToolTest, LeavesThePreviewsOfOtherToolsAlone) {
  canvas.preview.nodes = {{1, 2, 3}};
  document.setUnit(LengthUnit::millimeter);
  document.edit("Radius", [](SkeletonEditor& editor) { editor.setRadius(forkTop, 2); });
  mouse.hover(onNode(forkTop), {0, 1});
  EXPECT_EQ(canvas.preview.nodes.size(), 1U);
}

TEST_F(MeasureToolTest, EditsNothing) {
  click(onNode(forkRoot));
  click(onNode(forkTop));
  click(onNode(shoots[0]));
  EXPECT_EQ(document.undoStack().count(), 0);
  EXPECT_TRUE(document.selection().isEmpty());
}

} // namespace
} // namespace espalier
