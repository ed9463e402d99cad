#include "core/base/error.h"
#include "tests/support/plants.h"
#include "tests/ui/tools/mouse.h"
#include "tests/ui/tools/quiet_canvas.h"
#include "ui/document/length_unit.h"
#include "ui/tools/reparent_node_tool.h"

#include <QSignalSpy>
#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace espalier {
namespace {

using test::onNode;

struct ReparentNodeToolTest : testing::Test {
  PlantDocument document;
  test::QuietCanvas canvas;
  ReparentNodeTool tool{document, canvas};
  test::Mouse mouse{tool};

  void SetUp() override { document.openSkeleton(test::fork(3), "fork.mtg"); }
};

TEST_F(ReparentNodeToolTest, AttachesTheNodeToTheOneClicked) {
  const QSignalSpy finished(&tool, &Tool::finished);
  tool.startWith({NodeId{3}});
  EXPECT_TRUE(mouse.click(onNode(NodeId{4}), {0, 2}));
  EXPECT_EQ(document.skeleton()[NodeId{3}].parent, NodeId{4});
  EXPECT_EQ(document.undoStack().undoText(), "Reparent node 3 to 4");
  EXPECT_EQ(finished.size(), 1);
  document.undoStack().undo();
  EXPECT_EQ(document.skeleton(), test::fork(3));
}

// It may be off the screen by then.
TEST_F(ReparentNodeToolTest, ShowsWhereItsNodesAreAndHowLongTheEdgeWouldBe) {
  const Skeleton& plant = document.skeleton();
  document.setUnit(LengthUnit::meter);
  tool.startWith({NodeId{3}});
  ASSERT_EQ(canvas.preview.subjects.size(), 1U);
  EXPECT_EQ(canvas.preview.subjects[0], plant[NodeId{3}].position);
  mouse.hover(onNode(NodeId{4}), {1, 2});
  const double length = (plant[NodeId{3}].position - plant[NodeId{4}].position).norm();
  EXPECT_EQ(canvas.preview.label, formatLength(length, LengthUnit::meter));
  EXPECT_EQ(canvas.preview.subjects.size(), 1U);
  mouse.escape();
  EXPECT_TRUE(canvas.preview.isEmpty());
}

TEST_F(ReparentNodeToolTest, ChoosesTheNodeFirstWithoutOne) {
  mouse.click(onNode(NodeId{3}), {0, 2});
  EXPECT_EQ(document.selection().current(), NodeId{3});
  mouse.click(onNode(NodeId{2}), {1, 2});
  EXPECT_EQ(document.skeleton()[NodeId{3}].parent, NodeId{2});
}

TEST_F(ReparentNodeToolTest, AttachesSeveralNodesAtOnce) {
  tool.startWith({NodeId{3}, NodeId{4}});
  mouse.click(onNode(NodeId{2}), {1, 2});
  EXPECT_EQ(document.skeleton().children(NodeId{2}).size(), 2U);
  EXPECT_EQ(document.undoStack().undoText(), "Reparent 2 nodes to 2");
}

TEST_F(ReparentNodeToolTest, RefusesADescendantAndLetsOneTryAgain) {
  tool.startWith({test::forkTop});
  mouse.hover(onNode(NodeId{2}), {1, 2});
  EXPECT_TRUE(tool.hint().startsWith("Not there: it grows from node 1")) << qPrintable(tool.hint());
  EXPECT_TRUE(canvas.preview.lines.empty()) << "no edge is promised";
  EXPECT_THROW(mouse.press(onNode(NodeId{2}), {1, 2}), Error);
  EXPECT_EQ(document.skeleton(), test::fork(3));
  EXPECT_TRUE(tool.isBusy());
}

/// What a click is refused with; empty: nothing.
template <class Click> std::string refusalOf(const Click& click) {
  try {
    click();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

TEST_F(ReparentNodeToolTest, SaysWhyAClickIsNotTaken) {
  tool.startWith({NodeId{3}});
  EXPECT_TRUE(refusalOf([&] { mouse.click({}, {5, 5}); }).starts_with("no node or edge is there"));
  EXPECT_TRUE(refusalOf([&] {
                mouse.click(onNode(NodeId{3}), {1, 1});
              }).starts_with("node 3 is what is attached"));
  EXPECT_TRUE(tool.isBusy()) << "one tries again";
  tool.startWith({NodeId{3}, NodeId{4}});
  EXPECT_TRUE(refusalOf([&] {
                mouse.click(onNode(NodeId{4}), {0, 2});
              }).starts_with("node 4 is one of the 2 nodes that are attached"));
  EXPECT_EQ(document.skeleton(), test::fork(3));
  mouse.click(onNode(NodeId{2}), {1, 2});
  EXPECT_EQ(document.skeleton()[NodeId{4}].parent, NodeId{2});
}

TEST_F(ReparentNodeToolTest, LeavesEmptySpaceToTheCamera) {
  tool.startWith({NodeId{3}});
  EXPECT_FALSE(mouse.press({}, {5, 5}));
  EXPECT_FALSE(mouse.drag({9, 5}));
  EXPECT_FALSE(mouse.release());
  EXPECT_FALSE(mouse.press(onNode(NodeId{4}), {0, 2}, Qt::ControlModifier));
  EXPECT_EQ(document.skeleton(), test::fork(3));
}

TEST_F(ReparentNodeToolTest, EndsWithNothingChangedOnEscape) {
  const QSignalSpy finished(&tool, &Tool::finished);
  tool.startWith({NodeId{3}});
  mouse.escape();
  EXPECT_FALSE(tool.isBusy());
  EXPECT_EQ(finished.size(), 1);
  EXPECT_EQ(document.skeleton(), test::fork(3));
}

TEST_F(ReparentNodeToolTest, AttachesANodeToTheOneItIsDraggedOnto) {
  EXPECT_TRUE(mouse.press(onNode(NodeId{3}), {0, 2}));
  EXPECT_TRUE(mouse.drag({0.5, 2}));
  EXPECT_EQ(document.skeleton(), test::fork(3)) << "changed before it was dropped";
  mouse.drag({1, 2}, onNode(NodeId{4}));
  const Skeleton& plant = document.skeleton();
  ASSERT_EQ(canvas.preview.lines.size(), 1U);
  EXPECT_EQ(canvas.preview.lines[0].back(), plant[NodeId{4}].position);
  EXPECT_TRUE(mouse.release(onNode(NodeId{4})));
  EXPECT_TRUE(canvas.preview.isEmpty());
  EXPECT_EQ(document.skeleton()[NodeId{3}].parent, NodeId{4});
  EXPECT_FALSE(tool.isBusy());
  document.undoStack().undo();
  EXPECT_EQ(document.skeleton(), test::fork(3));
}

TEST_F(ReparentNodeToolTest, StaysForTheNextBranchUnlessAKeyStartedIt) {
  const QSignalSpy finished(&tool, &Tool::finished);
  mouse.press(onNode(NodeId{3}), {0, 2});
  mouse.drag({1, 2}, onNode(NodeId{4}));
  mouse.release(onNode(NodeId{4}));
  EXPECT_EQ(finished.size(), 0);
}

TEST_F(ReparentNodeToolTest, PutsBackABranchDroppedOnNothing) {
  mouse.press(onNode(NodeId{3}), {0, 2});
  mouse.drag({5, 5});
  mouse.release();
  EXPECT_FALSE(tool.isBusy());
  EXPECT_EQ(document.skeleton(), test::fork(3));
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(ReparentNodeToolTest, PutsBackOnEscapeInMidDrag) {
  mouse.press(onNode(NodeId{3}), {0, 2});
  mouse.drag({1, 2}, onNode(NodeId{4}));
  mouse.escape();
  mouse.release(onNode(NodeId{4}));
  EXPECT_EQ(document.skeleton(), test::fork(3));
}

TEST_F(ReparentNodeToolTest, GivesTheEdgeItIsAttachedToANode) {
  tool.startWith({NodeId{3}});
  const Pick half = test::onEdge(document.skeleton(), NodeId{4}, 0.5);
  const Eigen::Vector3d place = half.edge->position;
  mouse.click(half, {0, 2});
  const Skeleton& plant = document.skeleton();
  ASSERT_EQ(plant.size(), test::fork(3).size() + 1);
  const NodeId parent = *plant[NodeId{3}].parent;
  EXPECT_TRUE(plant[parent].position.isApprox(place));
  EXPECT_EQ(plant[NodeId{4}].parent, parent);
  EXPECT_EQ(document.undoStack().count(), 1) << "one step for both";
}

TEST_F(ReparentNodeToolTest, RefusesAnEdgeThatTheBranchCarries) {
  tool.startWith({test::forkTop});
  mouse.hover(test::onEdge(document.skeleton(), NodeId{3}, 0.5), {0, 2});
  EXPECT_TRUE(tool.hint().startsWith("Not there")) << qPrintable(tool.hint());
  EXPECT_THROW(mouse.press(test::onEdge(document.skeleton(), NodeId{3}, 0.5), {0, 2}), Error);
  EXPECT_EQ(document.skeleton(), test::fork(3));
}

TEST_F(ReparentNodeToolTest, EnterAttachesToTheNearestThatMayBearIt) {
  const QSignalSpy finished(&tool, &Tool::finished);
  document.edit("Move", [](SkeletonEditor& editor) { // nearer to each other than to the root
    editor.setPosition(NodeId{2}, {0.2, 0, 2});
    editor.setPosition(NodeId{3}, {0.1, 0, 2});
  });
  const Skeleton before = document.skeleton();
  EXPECT_FALSE(tool.hasPreview());
  tool.startWith({NodeId{3}});
  ASSERT_TRUE(tool.hasPreview());
  ASSERT_EQ(canvas.preview.lines.size(), 1U);
  EXPECT_EQ(canvas.preview.lines[0].back(), before[NodeId{2}].position);
  EXPECT_THAT(tool.hint().toStdString(), testing::StartsWith("Enter: attach node 3 to node 2 "));
  tool.accept();
  EXPECT_EQ(document.skeleton()[NodeId{3}].parent, NodeId{2});
  EXPECT_EQ(finished.size(), 1);
  document.undoStack().undo();
  EXPECT_EQ(document.skeleton(), before);
}

TEST_F(ReparentNodeToolTest, EnterAttachesToTheNodeThatKeysHaveSteppedTo) {
  mouse.hover(onNode(NodeId{2}), {1, 2});
  tool.startWith({NodeId{3}});
  document.selection().set({test::forkRoot}); // as arrow keys do
  EXPECT_THAT(tool.hint().toStdString(), testing::StartsWith("Enter: attach node 3 to node 0 "));
  EXPECT_EQ(canvas.preview.lines.at(0).back(), document.skeleton()[test::forkRoot].position);
  mouse.hover(onNode(NodeId{2}), {1, 2}); // the camera has moved, and the pointer has not
  EXPECT_EQ(canvas.preview.lines.at(0).back(), document.skeleton()[test::forkRoot].position);
  tool.accept();
  EXPECT_EQ(document.skeleton()[NodeId{3}].parent, test::forkRoot);
  EXPECT_EQ(document.selection().nodes(), std::vector{NodeId{3}}) << "what was attached";
}

TEST_F(ReparentNodeToolTest, ThePointerLeadsOnceItMovesOntoANode) {
  tool.startWith({NodeId{3}});
  document.selection().set({test::forkRoot});
  mouse.hover(onNode(NodeId{4}), {0, 2});
  EXPECT_THAT(tool.hint().toStdString(), testing::StartsWith("Click: attach node 3 to node 4 "));
  tool.accept();
  EXPECT_EQ(document.skeleton()[NodeId{3}].parent, NodeId{4}) << "what was shown";
}

TEST_F(ReparentNodeToolTest, EnterIsRefusedOnWhatTheBranchCarriesAndLetsOneStepOn) {
  tool.startWith({test::forkTop});
  EXPECT_FALSE(tool.hasPreview()) << "nothing but its parent is left";
  document.selection().set({NodeId{2}});
  EXPECT_THROW(tool.accept(), Error);
  EXPECT_TRUE(tool.isBusy());
  EXPECT_EQ(document.skeleton(), test::fork(3));
}

TEST_F(ReparentNodeToolTest, EscapeSelectsWhatWasToBeAttached) {
  tool.startWith({NodeId{3}});
  document.selection().set({test::forkRoot});
  mouse.escape();
  EXPECT_EQ(document.selection().nodes(), std::vector{NodeId{3}});
}

TEST_F(ReparentNodeToolTest, ForgetsANodeThatIsGone) {
  tool.startWith({NodeId{3}});
  document.edit("Remove", [](SkeletonEditor& editor) { editor.erase(NodeId{3}); });
  mouse.click(onNode(NodeId{4}), {0, 2}); // chooses it
  EXPECT_EQ(document.selection().current(), NodeId{4});
}

} // namespace
} // namespace espalier
