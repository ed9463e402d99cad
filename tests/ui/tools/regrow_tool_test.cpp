#include "core/base/error.h"
#include "core/skeleton/axes.h"
#include "tests/support/plants.h"
#include "tests/ui/tools/mouse.h"
#include "tests/ui/tools/quiet_canvas.h"
#include "ui/tools/regrow_tool.h"

#include <QSignalSpy>
#include <gtest/gtest.h>

#include <gmock/gmock.h>

namespace espalier {
namespace {

struct RegrowToolTest : testing::Test {
  PlantDocument document;
  test::QuietCanvas canvas;
  RegrowTool tool{document, canvas};
  test::Mouse mouse{tool};
  std::vector<NodeId> wanted;
  Skeleton before;

  void SetUp() override {
    document.openSkeleton(test::fork(3), "fork.mtg");
    before = document.skeleton();
    QObject::connect(&tool, &RegrowTool::wanted, &document,
                     [this](NodeId node) { wanted.push_back(node); });
  }
};

TEST_F(RegrowToolTest, WantsTheNodeThatIsClicked) {
  mouse.click(test::onNode(test::forkTop), {0, 1});
  EXPECT_THAT(wanted, testing::ElementsAre(test::forkTop));
}

TEST_F(RegrowToolTest, SaysAtAClickOnAnEdgeWhatToClick) {
  const Pick edge = test::onEdge(before, test::forkTop, 0.5);
  EXPECT_FALSE(mouse.press(edge, {0, 0.5})) << "a drag from there turns the view";
  mouse.drag({1, 0.5});
  EXPECT_NO_THROW(mouse.release());
  EXPECT_FALSE(mouse.press(edge, {0, 0.5}));
  EXPECT_THROW(mouse.release(edge), Error);
  EXPECT_TRUE(wanted.empty());
}

TEST_F(RegrowToolTest, ReplacesWhatTheNodeCarriesOnceAccepted) {
  const QSignalSpy finished(&tool, &Tool::finished);
  tool.show(test::forkTop, test::stick(3));
  EXPECT_EQ(canvas.preview.lines.size(), 2U);
  EXPECT_EQ(document.skeleton(), before);
  ASSERT_TRUE(tool.hasPreview());
  tool.accept();
  EXPECT_EQ(document.skeleton().size(), 4U); // root, top, two new ones
  EXPECT_EQ(document.skeleton()[test::forkTop], before[test::forkTop]);
  EXPECT_TRUE(canvas.preview.isEmpty());
  EXPECT_EQ(finished.size(), 1);
  document.undoStack().undo();
  EXPECT_EQ(document.skeleton(), before);
}

TEST_F(RegrowToolTest, DropsWhatGrewOnEscape) {
  tool.show(test::forkTop, test::stick(3));
  mouse.escape();
  EXPECT_FALSE(tool.hasPreview());
  EXPECT_TRUE(canvas.preview.isEmpty());
  EXPECT_EQ(document.skeleton(), before);
}

TEST_F(RegrowToolTest, RefusesSeveralNodes) {
  EXPECT_THROW(tool.startWith({NodeId{2}, NodeId{3}}), Error);
  EXPECT_TRUE(wanted.empty());
}

TEST_F(RegrowToolTest, AddsTheBranchesThatAreMissingOnceAccepted) {
  const QSignalSpy finished(&tool, &Tool::finished);
  tool.show({{test::forkTop, test::stick(3)}, {NodeId{2}, test::stick(2)}}, "Regrow");
  EXPECT_EQ(canvas.preview.lines.size(), 3U);
  EXPECT_TRUE(tool.hint().contains("3 new nodes"));
  EXPECT_EQ(document.skeleton(), before);
  tool.accept();
  EXPECT_EQ(document.skeleton().size(), before.size() + 3);
  for (const NodeId id : before.ids())
    EXPECT_EQ(document.skeleton()[id], before[id]) << "nothing else changes";
  EXPECT_EQ(document.selection().nodes().size(), 3U);
  EXPECT_TRUE(canvas.preview.isEmpty());
  EXPECT_EQ(finished.size(), 1);
  EXPECT_EQ(document.undoStack().undoText(), "Regrow");
  document.undoStack().undo();
  EXPECT_EQ(document.skeleton(), before);
}

TEST_F(RegrowToolTest, DropsMissingBranchesOnEscape) {
  tool.show({{test::forkTop, test::stick(3)}}, "Regrow");
  mouse.escape();
  EXPECT_FALSE(tool.hasPreview());
  EXPECT_TRUE(canvas.preview.isEmpty());
  EXPECT_EQ(document.skeleton(), before);
}

// Sticks of 1, 2, ... 10 on the nodes of a stick, the shortest first.
TEST_F(RegrowToolTest, ShowsTheLongestBranchesFirst) {
  document.openSkeleton(test::stick(11), "stick.mtg");
  std::vector<GrownBranch> branches;
  for (int length = 1; length <= 10; ++length)
    branches.push_back({NodeId{static_cast<std::uint32_t>(length)}, test::stick(length + 1)});
  tool.show(branches, "Regrow", 5.5);
  EXPECT_EQ(canvas.preview.lines.size(), 6U + 7 + 8 + 9 + 10) << "an edge for each unit";
  EXPECT_TRUE(tool.hint().contains("5 of 10 branches")) << tool.hint().toStdString();
  EXPECT_TRUE(tool.hint().contains("from 6"));
  EXPECT_TRUE(tool.hint().contains("40 new nodes"));
  tool.showMore(); // a fifth of five
  EXPECT_EQ(canvas.preview.lines.size(), 45U);
  tool.showFewer();
  tool.showFewer();
  EXPECT_EQ(canvas.preview.lines.size(), 7U + 8 + 9 + 10);
  tool.accept();
  EXPECT_EQ(document.skeleton().size(), 11U + 34) << "what is not shown is not added";
}

TEST_F(RegrowToolTest, ShowsAllBranchesAtMostAndOneAtLeast) {
  tool.show({{test::forkTop, test::stick(3)}, {NodeId{2}, test::stick(2)}}, "Regrow", 100);
  EXPECT_EQ(canvas.preview.lines.size(), 2U) << "the longest, though it is short";
  EXPECT_FALSE(tool.canShowFewer());
  tool.showFewer();
  EXPECT_EQ(canvas.preview.lines.size(), 2U);
  tool.showMore();
  EXPECT_EQ(canvas.preview.lines.size(), 3U);
  EXPECT_FALSE(tool.canShowMore());
  tool.showMore();
  EXPECT_EQ(canvas.preview.lines.size(), 3U);
  tool.cancel();
  EXPECT_FALSE(tool.canShowFewer());
  EXPECT_FALSE(tool.canShowMore());
}

TEST_F(RegrowToolTest, WalksSeveralBranchesOneByOne) {
  document.openSkeleton(test::stick(11), "stick.mtg");
  std::vector<std::vector<Eigen::Vector3d>> reached;
  QObject::connect(&tool, &RegrowTool::reached, &document,
                   [&](const std::vector<Eigen::Vector3d>& places) { reached.push_back(places); });
  tool.show({{NodeId{1}, test::stick(5)}, {NodeId{2}, test::stick(4)}, {NodeId{3}, test::stick(3)}},
            "Regrow");
  ASSERT_EQ(reached.size(), 1U) << "the first at once";
  EXPECT_EQ(reached[0].size(), 5U) << "the longest";
  EXPECT_EQ(canvas.preview.lines.size(), 9U);
  EXPECT_EQ(canvas.preview.nodes.size(), 4U) << "of the one that is to be chosen";
  EXPECT_TRUE(tool.canChoose());
  tool.takeCurrent();
  ASSERT_EQ(reached.size(), 2U);
  EXPECT_EQ(reached[1].size(), 4U);
  tool.dropCurrent();
  EXPECT_EQ(canvas.preview.lines.size(), 6U) << "what is dropped is shown no more";
  EXPECT_EQ(document.skeleton().size(), 11U) << "nothing is made before the last";
  tool.takeCurrent();
  EXPECT_FALSE(tool.hasPreview());
  EXPECT_EQ(document.skeleton().size(), 11U + 4 + 2);
  EXPECT_EQ(document.undoStack().count(), 1) << "all that was taken is one step";
  document.undoStack().undo();
  EXPECT_EQ(document.skeleton().size(), 11U);
}

TEST_F(RegrowToolTest, TakesAllButWhatWasDropped) {
  document.openSkeleton(test::stick(11), "stick.mtg");
  tool.show({{NodeId{1}, test::stick(5)}, {NodeId{2}, test::stick(4)}, {NodeId{3}, test::stick(3)}},
            "Regrow");
  tool.dropCurrent();
  tool.accept();
  EXPECT_EQ(document.skeleton().size(), 11U + 3 + 2);
}

TEST_F(RegrowToolTest, LeavesTheWalkWithNothingChanged) {
  const QSignalSpy finished(&tool, &Tool::finished);
  const auto start = [&] {
    tool.show({{test::forkTop, test::stick(3)}, {NodeId{2}, test::stick(2)}}, "Regrow");
  };
  start();
  tool.takeCurrent();
  mouse.escape();
  EXPECT_EQ(document.skeleton(), before);
  start();
  tool.dropCurrent();
  tool.dropCurrent();
  EXPECT_EQ(document.skeleton(), before) << "all were dropped";
  EXPECT_FALSE(tool.hasPreview());
  EXPECT_FALSE(document.undoStack().canUndo());
  EXPECT_EQ(finished.size(), 2);
}

TEST_F(RegrowToolTest, ChoosesNothingWhereOneBranchIsProposed) {
  tool.show({{test::forkTop, test::stick(3)}}, "Regrow");
  EXPECT_FALSE(tool.canChoose());
  tool.takeCurrent();
  tool.dropCurrent();
  EXPECT_TRUE(tool.hasPreview());
}

// The axis of the root of the fork carries a branch: dropped with it, or alone.
TEST_F(RegrowToolTest, WalksTheAxesOfWhatANodeIsToCarry) {
  const Skeleton part = test::fork(3);
  ASSERT_EQ(axes(part).size(), 3U);
  tool.show(test::forkTop, part);
  tool.takeCurrent();
  tool.dropCurrent();
  tool.takeCurrent();
  const std::size_t dropped = axes(part)[1].size();
  EXPECT_EQ(document.skeleton().size(), 2 + part.size() - 1 - dropped);
  document.undoStack().undo();
  EXPECT_EQ(document.skeleton(), before);
  tool.show(test::forkTop, part);
  tool.dropCurrent();
  EXPECT_FALSE(tool.hasPreview()) << "it carries the others";
  EXPECT_EQ(document.skeleton(), before);
}

TEST_F(RegrowToolTest, AddsNothingIfANodeIsGoneMeanwhile) {
  tool.show({{test::forkRoot, test::stick(2)}, {NodeId{2}, test::stick(3)}}, "Regrow");
  document.edit("Remove", [](SkeletonEditor& editor) { editor.erase(NodeId{2}); });
  const Skeleton pruned = document.skeleton();
  EXPECT_THROW(tool.accept(), Error);
  EXPECT_EQ(document.skeleton(), pruned);
  EXPECT_TRUE(tool.hasPreview());
}

} // namespace
} // namespace espalier
