#include "tests/support/clouds.h"
#include "tests/support/plants.h"
#include "tests/ui/tools/mouse.h"
#include "tests/ui/tools/quiet_canvas.h"
#include "ui/tools/move_node_tool.h"

#include <QTest>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
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

TEST_F(MoveNodeToolTest, ChoosesOneOfSeveralChosenNodesByAClick) {
  document.selection().set({NodeId{2}, NodeId{3}, NodeId{4}});
  mouse.press(onNode(NodeId{3}), {0, 2});
  EXPECT_EQ(chosen().size(), 3U) << "a drag would move them all";
  mouse.release();
  EXPECT_THAT(chosen(), ElementsAre(NodeId{3}));
  EXPECT_EQ(document.undoStack().count(), 0);
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

TEST_F(MoveNodeToolTest, IsFreeAfterADragWhoseReleaseIsNotSent) {
  mouse.press(onNode(NodeId{2}), {1, 2});
  mouse.drag({2, 2});
  mouse.escape();
  EXPECT_TRUE(tool.isBusy());
  mouse.hover({}, {5, 5});
  EXPECT_FALSE(tool.isBusy());
  EXPECT_EQ(document.skeleton(), test::fork(3));
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

// Node 1 of the stick stands at z = 1, between 0 and 2.
struct SlideAndSnapTest : testing::Test {
  PlantDocument document;
  test::QuietCanvas canvas;
  MoveNodeTool tool{document, canvas};
  test::Mouse mouse{tool};
  const NodeId middle{1};

  void SetUp() override { document.openSkeleton(test::stick(3), "stick.mtg"); }
  /// A scan of wood of radius 0.1 about the line x = 0.05, and contracted points on that line.
  void openScan() {
    RawPoints raw;
    const Eigen::Matrix3Xf points = test::cylinder({0.05, 0, -0.1}, {0.05, 0, 2.1}, 0.1, 0.02);
    for (Eigen::Index i = 0; i < points.cols(); ++i)
      raw.positions.emplace_back(points.col(i).cast<double>());
    document.setScan(std::make_unique<const Scan>(PointCloud(std::move(raw))), "scan.xyz");
    const PointCloud& cloud = *document.scan()->cloud();
    Eigen::Matrix3Xf contracted = cloud.positions();
    contracted.row(0).setConstant(static_cast<float>(0.05 - cloud.origin().x()));
    contracted.row(1).setConstant(static_cast<float>(-cloud.origin().y()));
    document.setContracted(std::make_shared<const Eigen::Matrix3Xf>(std::move(contracted)));
  }
  [[nodiscard]] Eigen::Vector3d place() { return document.skeleton()[middle].position; }
  void expectOneStep() {
    EXPECT_EQ(document.undoStack().count(), 1);
    document.undoStack().undo();
    EXPECT_EQ(document.skeleton(), test::stick(3));
  }
};

TEST_F(SlideAndSnapTest, ShiftSlidesTheNodeAlongItsAxis) {
  mouse.press(onNode(middle), {0.02, 1}); // beside its middle
  mouse.drag({0.5, 1.2});
  EXPECT_TRUE(place().isApprox(Eigen::Vector3d(0.48, 0, 1.2)));
  mouse.hold(Qt::ShiftModifier);
  mouse.drag({0.5, 1.4});
  EXPECT_TRUE(place().isApprox(Eigen::Vector3d(0, 0, 1.4)));
  EXPECT_TRUE(tool.hint().contains("Along its axis"));
  mouse.drag({-0.7, 0.75});
  EXPECT_TRUE(place().isApprox(Eigen::Vector3d(0, 0, 0.75)));
  mouse.hold(Qt::NoModifier);
  mouse.drag({-0.7, 0.75});
  EXPECT_TRUE(place().isApprox(Eigen::Vector3d(-0.72, 0, 0.75))) << "free again";
  mouse.hold(Qt::ShiftModifier);
  mouse.drag({-0.7, 0.75});
  mouse.release();
  EXPECT_TRUE(place().isApprox(Eigen::Vector3d(0, 0, 0.75)));
  expectOneStep();
}

TEST_F(SlideAndSnapTest, PutsASlidNodeBackOnEscape) {
  mouse.press(onNode(middle), {0, 1});
  mouse.hold(Qt::ShiftModifier);
  mouse.drag({0.3, 1.5});
  mouse.escape();
  mouse.release();
  EXPECT_EQ(document.skeleton(), test::stick(3));
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(SlideAndSnapTest, CtrlPutsTheNodeInTheMiddleOfItsSection) {
  openScan();
  mouse.press(onNode(middle), {0, 1});
  mouse.hold(Qt::ControlModifier);
  mouse.drag({0.12, 1.3});
  EXPECT_NEAR(place().x(), 0.05, 0.01);
  EXPECT_NEAR(place().y(), 0, 0.01);
  EXPECT_NEAR(place().z(), 1.3, 0.03) << "it moves across its axis only";
  EXPECT_TRUE(tool.hint().contains("In the middle of its section"));
  mouse.release();
  expectOneStep();
}

TEST_F(SlideAndSnapTest, SnapsToContractedPointsUnlessCtrlIsHeld) {
  openScan();
  tool.setSnap(Snap::contracted);
  mouse.press(onNode(middle), {0, 1});
  mouse.drag({0.12, 1.3});
  EXPECT_NEAR(place().x(), 0.05, 1e-5);
  EXPECT_NEAR(place().y(), 0, 1e-5);
  EXPECT_NEAR(place().z(), 1.3, 0.02);
  EXPECT_TRUE(tool.hint().contains("On the contracted points"));
  EXPECT_TRUE(tool.hint().contains("Ctrl: freely"));
  mouse.hold(Qt::ControlModifier);
  mouse.drag({0.12, 1.3});
  EXPECT_TRUE(place().isApprox(Eigen::Vector3d(0.12, 0, 1.3)));
  mouse.hold(Qt::NoModifier);
  mouse.drag({3, 1.3});
  EXPECT_TRUE(place().isApprox(Eigen::Vector3d(3, 0, 1.3))) << "nothing is near";
  mouse.release();
  expectOneStep();
}

TEST_F(SlideAndSnapTest, SnapsToNothingThatIsSetAside) {
  openScan();
  document.leaveOut("All", PointSet::firstOf(document.scan()->cloud()->size()));
  for (const Snap snap : {Snap::contracted, Snap::section}) {
    tool.setSnap(snap);
    mouse.press(onNode(middle), {place().x(), place().z()});
    mouse.drag({0.12, 1.3});
    EXPECT_NEAR(place().x(), 0.12, 1e-9);
    mouse.escape();
    mouse.release();
  }
}

TEST_F(SlideAndSnapTest, SlidesNoneOfSeveralNodes) {
  openScan();
  document.selection().set({middle, NodeId{2}});
  mouse.press(onNode(middle), {0, 1});
  mouse.hold(Qt::ShiftModifier);
  mouse.drag({0.12, 1.1});
  mouse.release();
  EXPECT_TRUE(place().isApprox(Eigen::Vector3d(0.12, 0, 1.1)));
  EXPECT_TRUE(document.skeleton()[NodeId{2}].position.isApprox(Eigen::Vector3d(0.12, 0, 2.1)));
}

TEST_F(SlideAndSnapTest, SnapsEachOfSeveralNodes) {
  openScan();
  for (const Snap snap : {Snap::contracted, Snap::section}) {
    tool.setSnap(snap);
    document.selection().set({middle, NodeId{2}});
    mouse.press(onNode(middle), {0, 1});
    mouse.drag({0.1, 0.8});
    for (const auto& [id, height] : {std::pair(middle, 0.8), std::pair(NodeId{2}, 1.8)}) {
      const Eigen::Vector3d& at = document.skeleton()[id].position;
      EXPECT_NEAR(at.x(), 0.05, 0.015) << indexOf(id);
      EXPECT_NEAR(at.y(), 0, 0.015) << indexOf(id);
      EXPECT_NEAR(at.z(), height, 0.04) << indexOf(id);
    }
    mouse.hold(Qt::ControlModifier);
    mouse.drag({0.1, 0.8});
    EXPECT_TRUE(place().isApprox(Eigen::Vector3d(0.1, 0, 0.8))) << "Ctrl lets them go";
    mouse.hold(Qt::NoModifier);
    mouse.drag({0.1, 0.8});
    mouse.escape();
    mouse.release();
    EXPECT_EQ(document.skeleton(), test::stick(3));
    EXPECT_EQ(document.undoStack().count(), 0);
  }
}

// A stick of 101 nodes, all selected, that is held in the middle.
struct SnapManyTest : SlideAndSnapTest {
  const Skeleton many = test::stick(101, 0.02);
  const NodeId held{50};

  void SetUp() override {
    SlideAndSnapTest::SetUp();
    document.openSkeleton(many, "stick.mtg");
    openScan();
    tool.setSnap(Snap::contracted);
    document.selection().set(many.ids());
    mouse.press(onNode(held), {0, 1});
  }
  double across(NodeId id) { return document.skeleton()[id].position.x(); }
  bool areAllSnapped() {
    return std::ranges::all_of(many.ids(),
                               [&](NodeId id) { return std::abs(across(id) - 0.05) < 1e-5; });
  }
};

TEST_F(SnapManyTest, ThoseNearThePointerSnapAtOnceAndTheOthersWhenItRests) {
  mouse.drag({0.1, 1});
  EXPECT_NEAR(across(held), 0.05, 1e-5);
  EXPECT_NEAR(across(NodeId{0}), 0.1, 1e-9) << "far from the pointer: it follows it so far";
  EXPECT_TRUE(QTest::qWaitFor([&] { return areAllSnapped(); }));
  mouse.drag({0.11, 1});
  EXPECT_NEAR(across(NodeId{0}), 0.11, 1e-9);
  mouse.escape();
  QTest::qWait(100); // longer than the pause
  EXPECT_EQ(document.skeleton(), many);
  mouse.release();
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(SnapManyTest, AllSnapWhenTheyAreLetGo) {
  mouse.drag({0.1, 1});
  mouse.release();
  EXPECT_TRUE(areAllSnapped());
  EXPECT_EQ(document.undoStack().count(), 1);
  document.undoStack().undo();
  EXPECT_EQ(document.skeleton(), many);
}

TEST_F(SlideAndSnapTest, SaysThatThereAreNoContractedPoints) {
  openScan();
  document.setContracted(nullptr);
  tool.setSnap(Snap::contracted);
  mouse.press(onNode(middle), {0, 1});
  mouse.drag({0.12, 1.3});
  EXPECT_TRUE(place().isApprox(Eigen::Vector3d(0.12, 0, 1.3)));
  EXPECT_TRUE(tool.hint().contains("No contracted points"));
}

} // namespace
} // namespace espalier
