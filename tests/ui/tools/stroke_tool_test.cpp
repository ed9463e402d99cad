#include "core/base/error.h"
#include "tests/support/plants.h"
#include "tests/ui/tools/line_scan.h"
#include "tests/ui/tools/mouse.h"
#include "tests/ui/tools/quiet_canvas.h"
#include "ui/tools/stroke_tool.h"

#include <gtest/gtest.h>

namespace espalier {
namespace {

using test::onNode;
using test::onPoint;

/// Two stems that cross at (0.5, 0, 1): nodes 0 1 from the left foot, 2 3 from the right.
Skeleton crossedStems() {
  Skeleton plant;
  const NodeId left = plant.add({.position = {0, 0, 0}, .radius = 0.1});
  plant.add({.position = {1, 0, 2}, .radius = 0.1, .parent = left});
  const NodeId right = plant.add({.position = {1, 0, 0}, .radius = 0.1});
  plant.add({.position = {0, 0, 2}, .radius = 0.1, .parent = right});
  return plant;
}

struct StrokeToolTest : testing::Test {
  PlantDocument document;
  test::QuietCanvas canvas;
  StrokeTool tool{document, canvas};
  test::Mouse mouse{tool};
  std::vector<TraceQuestion> questions;
  TraceAnswer answer; // of the last question
  Skeleton before;

  void open(const Skeleton& plant) {
    document.openSkeleton(plant, "plant.mtg");
    document.setScan(test::lineScan(), "scan.ply");
    before = plant;
    canvas.nodes = plant.ids(); // all are seen
    QObject::connect(&tool, &StrokeTool::asked, &document,
                     [this](const TraceQuestion& question, const TraceAnswer& callback) {
                       questions.push_back(question);
                       answer = callback;
                     });
  }
  void draw(const std::vector<Eigen::Vector2d>& places,
            Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    mouse.press({}, places.front(), modifiers);
    for (const Eigen::Vector2d& place : places)
      mouse.drag(place);
  }
  void drawBranch(const std::vector<Eigen::Vector3d>& points) { // of forkTop
    const Eigen::Vector3d& top = document.skeleton()[test::forkTop].position;
    mouse.press(onNode(test::forkTop), {top.x(), top.z()});
    for (const Eigen::Vector3d& point : points)
      mouse.drag({point.x(), point.z()}, onPoint(point));
    mouse.release();
  }
  void expectUndone() {
    document.undoStack().undo();
    EXPECT_EQ(document.skeleton(), before);
    EXPECT_FALSE(document.undoStack().canUndo());
  }
};

TEST_F(StrokeToolTest, CutsTheEdgesItCrosses) {
  open(crossedStems());
  draw({{-0.5, 0.4}, {1.5, 0.4}}); // below the crossing
  EXPECT_TRUE(tool.hint().contains("cut off 2 nodes")) << tool.hint().toStdString();
  EXPECT_EQ(document.skeleton(), before) << "changed before the release";
  mouse.release();
  EXPECT_EQ(document.skeleton().roots().size(), 4U);
  EXPECT_TRUE(canvas.band.isEmpty());
  expectUndone();
}

TEST_F(StrokeToolTest, LeavesEdgesBehindWood) {
  open(crossedStems());
  canvas.nodes = {NodeId{0}, NodeId{1}};
  draw({{-0.5, 0.4}, {1.5, 0.4}});
  mouse.release();
  EXPECT_FALSE(document.skeleton()[NodeId{1}].parent);
  EXPECT_TRUE(document.skeleton()[NodeId{3}].parent);
}

TEST_F(StrokeToolTest, ExchangesTheArmsOfACrossing) {
  open(crossedStems());
  draw({{0.2, 1}, {0.5, 1}, {0.8, 1}});
  EXPECT_TRUE(tool.hint().contains("exchange the arms")) << tool.hint().toStdString();
  mouse.release();
  EXPECT_EQ(document.skeleton()[NodeId{1}].parent, NodeId{2});
  EXPECT_EQ(document.skeleton()[NodeId{3}].parent, NodeId{0});
  expectUndone();
}

TEST_F(StrokeToolTest, ExchangesTheArmsInALoop) {
  open(crossedStems());
  draw({{0.2, 0.7}, {0.8, 0.7}, {0.8, 1.3}, {0.2, 1.3}, {0.2, 0.72}});
  mouse.release();
  EXPECT_EQ(document.skeleton()[NodeId{1}].parent, NodeId{2});
  EXPECT_EQ(document.skeleton()[NodeId{3}].parent, NodeId{0});
}

TEST_F(StrokeToolTest, ExchangesInALoopWhatLiesBehindTheOther) {
  open(crossedStems());
  canvas.nodes = {NodeId{0}, NodeId{1}};
  draw({{0.2, 0.7}, {0.8, 0.7}, {0.8, 1.3}, {0.2, 1.3}, {0.2, 0.72}});
  EXPECT_TRUE(tool.hint().contains("exchange the arms")) << tool.hint().toStdString();
  mouse.release();
  EXPECT_EQ(document.skeleton()[NodeId{1}].parent, NodeId{2});
  EXPECT_EQ(document.skeleton()[NodeId{3}].parent, NodeId{0});
}

TEST_F(StrokeToolTest, OnlyCutsWithShift) {
  open(crossedStems());
  draw({{0.2, 1}, {0.5, 1}, {0.8, 1}}, Qt::ShiftModifier);
  mouse.release();
  EXPECT_EQ(document.skeleton().roots().size(), 4U);
}

TEST_F(StrokeToolTest, RefusesToExchangeWhatDoesNotCross) {
  open(crossedStems());
  draw({{0, 0.4}, {0.4, 0.4}}, Qt::AltModifier);
  EXPECT_THROW(mouse.release(), Error);
  EXPECT_EQ(document.skeleton(), before);
  EXPECT_FALSE(tool.isBusy());
  EXPECT_TRUE(canvas.band.isEmpty());
}

TEST_F(StrokeToolTest, MakesABranchAlongThePoints) {
  open(test::fork(3));
  mouse.press(onNode(test::forkTop), {0, 1});
  mouse.drag({1, 2.5}, onPoint({1, 0, 2.5}));
  mouse.drag({2, 3}, onPoint({2, 0, 3}));
  EXPECT_TRUE(tool.hint().contains("branch of node 1")) << tool.hint().toStdString();
  mouse.release();
  ASSERT_EQ(questions.size(), 1U);
  EXPECT_TRUE(questions.back().isDrawn);
  EXPECT_EQ(questions.back().places.size(), 3U);
  EXPECT_EQ(questions.back().places.front(), before[test::forkTop].position);
  EXPECT_TRUE(tool.isBusy());
  answer({{questions.back().places, {0, 0.05, 0.05}}});
  EXPECT_FALSE(tool.isBusy());
  ASSERT_EQ(document.skeleton().size(), before.size() + 2);
  EXPECT_TRUE(document.skeleton().isAncestor(test::forkTop, document.skeleton().ids().back()));
  expectUndone();
}

TEST_F(StrokeToolTest, MakesATreeOfItsOwnAwayFromNodes) {
  open(test::fork(3));
  mouse.press(onPoint({3, 0, 3}), {3, 3});
  mouse.drag({4, 3}, onPoint({4, 0, 3}));
  mouse.release();
  answer({{questions.back().places, {0.05, 0.05}}});
  EXPECT_EQ(document.skeleton().roots().size(), 2U);
  expectUndone();
}

TEST_F(StrokeToolTest, ChangesNothingOnEscape) {
  open(crossedStems());
  draw({{-0.5, 0.4}, {1.5, 0.4}});
  EXPECT_TRUE(mouse.escape());
  EXPECT_TRUE(canvas.band.isEmpty());
  mouse.release();
  EXPECT_EQ(document.skeleton(), before);
  EXPECT_FALSE(document.undoStack().canUndo());
}

TEST_F(StrokeToolTest, MakesNoBranchThatWasEscapedFrom) {
  open(test::fork(3));
  mouse.press(onPoint({3, 0, 3}), {3, 3});
  mouse.drag({4, 3}, onPoint({4, 0, 3}));
  mouse.release();
  mouse.escape();
  answer({{questions.back().places, {0.05, 0.05}}});
  EXPECT_EQ(document.skeleton(), before);
}

TEST_F(StrokeToolTest, DoesNothingInTheAir) {
  open(crossedStems());
  draw({{3, 3}, {4, 3}});
  mouse.release();
  EXPECT_EQ(document.skeleton(), before);
  EXPECT_FALSE(tool.isBusy());
}

TEST_F(StrokeToolTest, LeavesCtrlToTheCamera) {
  open(crossedStems());
  EXPECT_FALSE(mouse.press({}, {0, 0.4}, Qt::ControlModifier));
  EXPECT_FALSE(tool.isBusy());
}

TEST_F(StrokeToolTest, LeavesPointsOutThatAreFarBehindTheOthers) {
  open(test::fork(3));
  const Eigen::Vector3d first(0.3, -0.05, 1);
  const Eigen::Vector3d far(0.45, 5, 1); // through a gap
  const Eigen::Vector3d second(0.6, -0.05, 1);
  drawBranch({first, far, second});
  ASSERT_EQ(questions.size(), 1U);
  EXPECT_EQ(questions.back().places, (std::vector{before[test::forkTop].position, first, second}));
}

TEST_F(StrokeToolTest, FollowsABranchThatLeadsAwayFromTheEye) {
  open(test::fork(3));
  const std::vector<Eigen::Vector3d> branchPath = {{0.1, 0.3, 1}, {0.2, 0.6, 1}, {0.3, 0.9, 1}};
  drawBranch(branchPath);
  ASSERT_EQ(questions.size(), 1U);
  EXPECT_EQ(questions.back().places.size(), 4U);
}

} // namespace
} // namespace espalier
