#include "core/base/error.h"
#include "tests/support/plants.h"
#include "tests/ui/tools/mouse.h"
#include "tests/ui/tools/quiet_canvas.h"
#include "ui/tools/add_node_tool.h"

#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using test::onEdge;
using test::onNode;
using test::onPoint;

struct AddNodeToolTest : testing::Test {
  PlantDocument document;
  test::QuietCanvas canvas;
  AddNodeTool tool{document, canvas};
  test::Mouse mouse{tool};

  void SetUp() override { document.openSkeleton(test::stick(3), "stick.mtg"); }

  void openScan() {
    RawPoints raw;
    for (int i = 0; i < 5; ++i)
      raw.positions.emplace_back(0.01 * (i - 2), 0, 3);
    document.setScan(std::make_unique<Scan>(PointCloud(raw)), "scan.ply");
  }
  void expectUndoneAsOneStep(const Skeleton& before) {
    ASSERT_EQ(document.undoStack().count(), 1);
    document.undoStack().undo();
    EXPECT_EQ(document.skeleton(), before);
  }
};

TEST_F(AddNodeToolTest, PullsAChildOutOfANode) {
  mouse.press(onNode(NodeId{1}), {0, 1});
  mouse.drag({0.5, 1});
  mouse.drag({1, 1.5});
  mouse.release();
  const Node& added = document.skeleton()[NodeId{3}];
  EXPECT_TRUE(added.position.isApprox(Eigen::Vector3d(1, 0, 1.5)));
  EXPECT_EQ(added.parent, NodeId{1});
  EXPECT_EQ(added.edge, EdgeType::branching);
  EXPECT_EQ(document.selection().current(), NodeId{3});
  expectUndoneAsOneStep(test::stick(3));
}

TEST_F(AddNodeToolTest, ChoosesTheNodeClickedToGoOnFrom) {
  EXPECT_TRUE(mouse.click(onNode(NodeId{1}), {0, 1}));
  EXPECT_EQ(document.selection().current(), NodeId{1});
  EXPECT_EQ(document.skeleton(), test::stick(3));
}

TEST_F(AddNodeToolTest, InsertsANodeWhereAnEdgeIsPressedAndDragsIt) {
  mouse.press(onEdge(document.skeleton(), NodeId{2}, 0.25), {0, 1.25});
  EXPECT_TRUE(document.skeleton()[NodeId{3}].position.isApprox(Eigen::Vector3d(0, 0, 1.25)));
  mouse.drag({0.5, 1.5});
  mouse.release();
  EXPECT_TRUE(document.skeleton()[NodeId{3}].position.isApprox(Eigen::Vector3d(0.5, 0, 1.5)));
  EXPECT_EQ(document.skeleton()[NodeId{2}].parent, NodeId{3});
  expectUndoneAsOneStep(test::stick(3));
}

TEST_F(AddNodeToolTest, AddsAChainOfNodesAlongThePointsClicked) {
  openScan();
  document.selection().set({NodeId{2}});
  EXPECT_FALSE(mouse.click(onPoint({0.02, 0, 3}), {0, 3})) << "a drag there turns the view";
  mouse.click(onPoint({-0.02, 0, 3}), {0, 3});
  EXPECT_TRUE(document.skeleton()[NodeId{3}].position.isApprox(Eigen::Vector3d(0, 0, 3), 1e-6));
  EXPECT_EQ(document.skeleton()[NodeId{3}].parent, NodeId{2});
  EXPECT_EQ(document.skeleton()[NodeId{4}].parent, NodeId{3});
}

TEST_F(AddNodeToolTest, AddsNothingWhenTheViewWasTurned) {
  openScan();
  document.selection().set({NodeId{2}});
  mouse.press(onPoint({0, 0, 3}), {0, 3});
  mouse.drag({1, 3});
  mouse.drag({0, 3});
  mouse.release(onPoint({0, 0, 3}));
  EXPECT_EQ(document.skeleton(), test::stick(3));
}

TEST_F(AddNodeToolTest, RefusesAPointWithoutANodeToGoOnFrom) {
  openScan();
  mouse.press(onPoint({0, 0, 3}), {0, 3});
  EXPECT_THROW(mouse.release(onPoint({0, 0, 3})), Error);
  EXPECT_EQ(document.skeleton(), test::stick(3));
}

TEST_F(AddNodeToolTest, MakesTheRootOfAnEmptyPlant) {
  document.clear();
  openScan();
  mouse.click(onPoint({0, 0, 3}), {0, 3});
  ASSERT_EQ(document.skeleton().size(), 1U);
  EXPECT_EQ(document.selection().nodes().size(), 1U);
}

TEST_F(AddNodeToolTest, TakesThePullBackOnEscape) {
  mouse.press(onNode(NodeId{1}), {0, 1});
  mouse.drag({0.5, 1});
  EXPECT_TRUE(mouse.escape());
  mouse.drag({1, 1});
  mouse.release();
  EXPECT_EQ(document.skeleton(), test::stick(3));
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(AddNodeToolTest, IsFreeAfterAPullWhoseReleaseIsNotSent) {
  mouse.press(onNode(NodeId{1}), {0, 1});
  mouse.drag({0.5, 1});
  mouse.escape();
  mouse.hover({}, {5, 5});
  EXPECT_FALSE(tool.isBusy());
}

TEST_F(AddNodeToolTest, TakesTheInsertionBackOnEscape) {
  mouse.press(onEdge(document.skeleton(), NodeId{2}, 0.25), {0, 1.25});
  EXPECT_TRUE(mouse.escape());
  mouse.release();
  EXPECT_EQ(document.skeleton(), test::stick(3));
}

TEST_F(AddNodeToolTest, TurnsTheViewWithControl) {
  EXPECT_FALSE(mouse.press(onNode(NodeId{1}), {0, 1}, Qt::ControlModifier));
  EXPECT_FALSE(mouse.drag({0.5, 1}));
  EXPECT_EQ(document.skeleton(), test::stick(3));
}

} // namespace
} // namespace espalier
