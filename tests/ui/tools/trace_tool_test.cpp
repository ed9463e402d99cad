#include "core/base/error.h"
#include "core/skeleton/edits.h"
#include "tests/support/plants.h"
#include "tests/ui/tools/line_scan.h"
#include "tests/ui/tools/mouse.h"
#include "tests/ui/tools/quiet_canvas.h"
#include "ui/tools/trace_tool.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

using test::onEdge;
using test::onNode;
using test::onPoint;

/// Over the fork; who answers is given what it asks, and answers with straight paths.
struct TraceToolTest : testing::Test {
  PlantDocument document;
  test::QuietCanvas canvas;
  TraceTool tool{document, canvas};
  test::Mouse mouse{tool};
  std::vector<TraceQuestion> questions;
  TraceAnswer answer; // of the last question
  Skeleton before;

  void SetUp() override {
    document.openSkeleton(test::fork(3), "fork.mtg");
    document.setScan(test::lineScan(), "scan.ply");
    QObject::connect(&tool, &TraceTool::asked, &document,
                     [this](const TraceQuestion& question, const TraceAnswer& callback) {
                       questions.push_back(question);
                       answer = callback;
                     });
    before = document.skeleton();
  }
  /// By the middle between the ends; of several paths each is 1 higher than the one before.
  void reply(int paths = 1) {
    const Eigen::Vector3d from = questions.back().places.front();
    const Eigen::Vector3d to = questions.back().places.back();
    std::vector<Trace> traces;
    for (int i = 0; i < paths; ++i)
      traces.push_back({{from, (from + to) / 2 + i * Eigen::Vector3d::UnitZ(), to}, {0, 0.05, 0}});
    answer(traces);
  }
  void expectUndone() {
    document.undoStack().undo();
    EXPECT_EQ(document.skeleton(), before);
    EXPECT_FALSE(document.undoStack().canUndo());
  }
};

TEST_F(TraceToolTest, ShowsThePathToWhatIsUnderThePointer) {
  mouse.click(onNode(test::forkTop), {0, 1});
  mouse.hover(onPoint({2, 0, 3}), {2, 3});
  ASSERT_EQ(questions.size(), 1U);
  EXPECT_TRUE(questions.back().startIsFixed);
  EXPECT_FALSE(questions.back().endIsFixed);
  EXPECT_EQ(questions.back().options.alternatives, 0) << "while the pointer moves, one is enough";
  reply();
  ASSERT_EQ(canvas.preview.lines.size(), 1U);
  EXPECT_EQ(canvas.preview.lines.front().back(), Eigen::Vector3d(2, 0, 3));
  EXPECT_EQ(document.skeleton(), before) << "changed before it was accepted";
}

TEST_F(TraceToolTest, AttachesTheBranchToItsStart) {
  mouse.click(onNode(test::forkTop), {0, 1});
  mouse.click(onPoint({2, 0, 3}), {2, 3});
  EXPECT_EQ(questions.back().options.alternatives, 2);
  reply();
  ASSERT_TRUE(tool.hasPreview());
  tool.accept();
  ASSERT_EQ(document.skeleton().size(), before.size() + 2);
  const NodeId tip = document.skeleton().ids().back();
  const NodeId middle = *document.skeleton()[tip].parent;
  EXPECT_EQ(document.skeleton()[middle].parent, test::forkTop);
  EXPECT_EQ(document.skeleton()[middle].edge, EdgeType::branching);
  EXPECT_EQ(document.skeleton()[tip].edge, EdgeType::successor);
  EXPECT_EQ(document.skeleton()[tip].position, Eigen::Vector3d(2, 0, 3));
  EXPECT_FALSE(tool.isBusy());
  EXPECT_TRUE(canvas.preview.isEmpty());
  expectUndone();
}

TEST_F(TraceToolTest, GoesOnFromTheEndOfABranchThatWasClicked) {
  const NodeId end = before.ids().back();
  ASSERT_TRUE(before.children(end).empty());
  const Eigen::Vector3d tip = before[end].position;
  const Eigen::Vector3d along = tip - before[*before[end].parent].position;
  const auto traceOver = [&](const Eigen::Vector3d& next) {
    mouse.click(onNode(end), {0, 1});
    mouse.click(onPoint(next), {2, 3});
    answer({Trace{{tip - 0.2 * along, next}, {0.05, 0.05}, TraceBegin{end, 0.8}}});
    EXPECT_EQ(canvas.preview.nodes, std::vector{next});
    tool.accept();
  };
  traceOver(tip + along);
  ASSERT_EQ(document.skeleton().children(end).size(), 1U);
  EXPECT_EQ(document.skeleton().size(), before.size() + 1);
  document.undoStack().undo();
  const Eigen::Vector3d aside = along.unitOrthogonal() * along.norm();
  traceOver(tip - 0.1 * along + aside);
  EXPECT_TRUE(document.skeleton().children(end).empty())
      << "it turns back: its points leave the wood below";
  EXPECT_EQ(document.skeleton().size(), before.size() + 2);
}

TEST_F(TraceToolTest, StartsOnAnEdgeInTheSameStep) {
  mouse.click(onEdge(before, test::forkTop, 0.5), {0, 0.5});
  mouse.click(onPoint({2, 0, 3}), {2, 3});
  reply();
  tool.accept();
  EXPECT_EQ(document.skeleton().size(), before.size() + 3);
  const NodeId between = *document.skeleton()[test::forkTop].parent;
  EXPECT_NE(between, test::forkRoot);
  EXPECT_EQ(document.skeleton().children(between).size(), 2U);
  expectUndone();
}

TEST_F(TraceToolTest, MakesATreeOfItsOwnAwayFromNodes) {
  mouse.click(onPoint({1, 0, 3}), {1, 3});
  mouse.click(onPoint({2, 0, 3}), {2, 3});
  reply();
  tool.accept();
  EXPECT_EQ(document.skeleton().roots().size(), 2U);
  expectUndone();
}

TEST_F(TraceToolTest, IsAttachedToTheNodeThatItEndsAt) {
  mouse.click(onPoint({1, 0, 3}), {1, 3});
  mouse.click(onNode(NodeId{2}), {1, 2});
  reply();
  tool.accept();
  EXPECT_EQ(document.skeleton().roots().size(), 1U);
  EXPECT_EQ(document.skeleton()[document.skeleton().ids().back()].position,
            Eigen::Vector3d(1, 0, 3));
  expectUndone();
}

TEST_F(TraceToolTest, JoinsAnotherTree) {
  NodeId other{0};
  document.edit("Add", [&](SkeletonEditor& editor) {
    const NodeId root = editor.add({.position = {3, 0, 3}});
    other = addChild(editor, root, {2, 0, 3});
  });
  mouse.click(onNode(test::forkTop), {0, 1});
  mouse.click(onNode(other), {2, 3});
  reply();
  tool.accept();
  EXPECT_EQ(document.skeleton().roots().size(), 1U);
  EXPECT_EQ(document.skeleton().size(), before.size() + 3) << "one node between";
  EXPECT_TRUE(document.skeleton().isAncestor(test::forkTop, other));
}

TEST_F(TraceToolTest, RefusesALoop) {
  mouse.click(onNode(test::forkTop), {0, 1});
  EXPECT_THROW(mouse.click(onNode(NodeId{3}), {1, 2}), Error);
  EXPECT_TRUE(tool.isBusy()) << "one may end it elsewhere";
  EXPECT_EQ(document.skeleton(), before);
}

TEST_F(TraceToolTest, ShowsTheOtherPathsOneAfterTheOther) {
  mouse.click(onNode(test::forkTop), {0, 1});
  mouse.click(onPoint({2, 0, 3}), {2, 3});
  reply(2);
  ASSERT_TRUE(tool.hasOtherPaths());
  EXPECT_EQ(canvas.preview.lines.front()[1].z(), 2);
  tool.showNextPath();
  EXPECT_EQ(canvas.preview.lines.front()[1].z(), 3);
  tool.accept();
  const NodeId tip = document.skeleton().ids().back();
  EXPECT_EQ(document.skeleton()[*document.skeleton()[tip].parent].position.z(), 3);
}

TEST_F(TraceToolTest, DropsAllOnEscape) {
  mouse.click(onNode(test::forkTop), {0, 1});
  mouse.click(onPoint({2, 0, 3}), {2, 3});
  reply();
  EXPECT_TRUE(mouse.escape());
  EXPECT_FALSE(tool.isBusy());
  EXPECT_TRUE(canvas.preview.isEmpty());
  EXPECT_EQ(document.skeleton(), before);
}

TEST_F(TraceToolTest, TakesNoAnswerThatComesTooLate) {
  mouse.click(onNode(test::forkTop), {0, 1});
  mouse.click(onPoint({2, 0, 3}), {2, 3});
  mouse.escape();
  reply();
  EXPECT_FALSE(tool.hasPreview());
  EXPECT_TRUE(canvas.preview.isEmpty());
}

TEST_F(TraceToolTest, LeavesDragsToTheCamera) {
  mouse.press(onPoint({1, 0, 3}), {1, 3});
  EXPECT_FALSE(mouse.drag({2, 3}));
  mouse.release();
  EXPECT_FALSE(tool.isBusy());
}

TEST_F(TraceToolTest, NeedsAScan) {
  document.clear();
  document.openSkeleton(test::fork(3), "fork.mtg");
  EXPECT_THROW(mouse.click(onNode(test::forkTop), {0, 1}), Error);
  EXPECT_FALSE(tool.isBusy());
}

} // namespace
} // namespace espalier
