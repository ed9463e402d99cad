#include "core/base/error.h"
#include "tests/ui/tools/line_scan.h"
#include "tests/ui/tools/mouse.h"
#include "tests/ui/tools/quiet_canvas.h"
#include "ui/tools/select_points_tool.h"

#include <QLineF>
#include <gtest/gtest.h>

namespace espalier {
namespace {

using Shape = SelectPointsTool::Shape;

struct SelectPointsToolTest : testing::Test {
  PlantDocument document;
  test::QuietCanvas canvas;
  SelectPointsTool tool{document, canvas};
  test::Mouse mouse{tool};

  void SetUp() override { document.setScan(test::lineScan(), "line.xyz"); }
  [[nodiscard]] PointSet chosen() { return document.pointSelection().points(); }
  /// A stroke over which the view finds these points.
  void stroke(const std::vector<Eigen::Index>& points,
              Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    canvas.points = points;
    mouse.press({}, {0, 0}, modifiers);
    mouse.drag({1, 0});
    mouse.release();
  }
};

TEST_F(SelectPointsToolTest, ReplacesAddsAndTakesAwayWithEachShape) {
  for (const Shape shape : {Shape::brush, Shape::box, Shape::lasso}) {
    tool.setShape(shape);
    stroke({1, 2, 3});
    EXPECT_EQ(chosen(), PointSet::of({1, 2, 3}));
    stroke({3, 4}, Qt::ShiftModifier);
    EXPECT_EQ(chosen(), PointSet::of({1, 2, 3, 4}));
    stroke({1, 4, 8}, Qt::AltModifier);
    EXPECT_EQ(chosen(), PointSet::of({2, 3}));
    stroke({5});
    EXPECT_EQ(chosen(), PointSet::of({5}));
    EXPECT_EQ(document.undoStack().count(), 0) << "to choose is no edit";
  }
}

TEST_F(SelectPointsToolTest, SaysWhenAGestureHasEndedUnlessItWasCanceled) {
  int ended = 0;
  QObject::connect(&tool, &SelectPointsTool::ended, [&] { ++ended; });
  for (const Shape shape : {Shape::brush, Shape::box, Shape::lasso}) {
    tool.setShape(shape);
    stroke({1, 2, 3});
  }
  EXPECT_EQ(ended, 3);
  mouse.press({}, {0, 0});
  mouse.drag({1, 0});
  tool.cancel();
  mouse.release();
  EXPECT_EQ(ended, 3);
}

TEST_F(SelectPointsToolTest, SaysWhatPointsBecome) {
  EXPECT_FALSE(tool.hint().contains("become"));
  tool.setPurpose("blade");
  EXPECT_TRUE(tool.hint().startsWith("Points become blade   Drag: paint points"));
  mouse.press({}, {0, 0});
  EXPECT_EQ(tool.hint(), "Release: these points are blade   Esc: leave it");
  mouse.release();
  tool.setPurpose({});
  EXPECT_FALSE(tool.hint().contains("blade"));
}

// One pixel of the mouse is 0.01.
TEST_F(SelectPointsToolTest, PaintsWithADiscOfTheSizeOfTheBrush) {
  tool.setBrushSize(20);
  EXPECT_TRUE(mouse.press({}, {1, 1}));
  const QPointF center(100, -100);
  for (const QPointF& corner : canvas.asked)
    EXPECT_NEAR(QLineF(center, corner).length(), 20, 1e-9);
  EXPECT_GT(canvas.asked.size(), 16);
  mouse.drag({2, 1});
  EXPECT_TRUE(canvas.asked.containsPoint({150, -100}, Qt::WindingFill)) << "nothing is skipped";
  EXPECT_TRUE(canvas.asked.containsPoint({150, -119}, Qt::WindingFill));
  EXPECT_FALSE(canvas.asked.containsPoint({150, -121}, Qt::WindingFill));
  EXPECT_TRUE(canvas.asked.containsPoint({219, -100}, Qt::WindingFill));
  EXPECT_FALSE(canvas.asked.containsPoint({221, -100}, Qt::WindingFill));
}

TEST_F(SelectPointsToolTest, GathersWhatIsPaintedAsTheBrushMoves) {
  canvas.points = {1};
  mouse.press({}, {0, 0});
  canvas.points = {2};
  mouse.drag({1, 0});
  canvas.points = {7};
  mouse.drag({2, 0});
  EXPECT_EQ(chosen(), PointSet::of({1, 2, 7}));
  mouse.release();
  EXPECT_EQ(chosen(), PointSet::of({1, 2, 7}));
}

TEST_F(SelectPointsToolTest, ShowsTheBrushUnderThePointer) {
  tool.setBrushSize(30);
  mouse.hover({}, {1, 0});
  ASSERT_TRUE(canvas.band.isClosed());
  EXPECT_NEAR(canvas.band.boundingRect().width(), 60, 1);
  EXPECT_NEAR(canvas.band.boundingRect().center().x(), 100, 1);
  tool.setBrushSize(1e9);
  EXPECT_LE(canvas.band.boundingRect().width(), 601) << "it has its limits";
  tool.setShape(Shape::box);
  EXPECT_TRUE(canvas.band.isEmpty());
}

TEST_F(SelectPointsToolTest, DrawsABoxFromCornerToCorner) {
  tool.setShape(Shape::box);
  stroke({1});
  EXPECT_EQ(canvas.asked.boundingRect(), QRectF(0, 0, 100, 0));
  EXPECT_TRUE(canvas.band.isEmpty()) << "taken away once it is done";
}

TEST_F(SelectPointsToolTest, EscapeBringsBackWhatWasChosen) {
  for (const Shape shape : {Shape::brush, Shape::box}) {
    tool.setShape(shape);
    stroke({1, 2});
    canvas.points = {8};
    mouse.press({}, {0, 0});
    mouse.drag({1, 0});
    EXPECT_TRUE(tool.isBusy());
    EXPECT_TRUE(mouse.escape());
    mouse.drag({2, 0});
    mouse.release();
    EXPECT_EQ(chosen(), PointSet::of({1, 2}));
    EXPECT_FALSE(tool.isBusy());
  }
}

TEST_F(SelectPointsToolTest, ChoosesNoneByAClickBesideAllPoints) {
  for (const Shape shape : {Shape::brush, Shape::lasso}) {
    tool.setShape(Shape::brush);
    stroke({1, 2});
    tool.setShape(shape);
    canvas.points = {};
    mouse.click({}, {5, 5}, Qt::ShiftModifier);
    EXPECT_EQ(chosen(), PointSet::of({1, 2})) << "nothing is added";
    mouse.click({}, {5, 5});
    EXPECT_TRUE(chosen().isEmpty());
  }
}

TEST_F(SelectPointsToolTest, LeavesOtherButtonsToTheCamera) {
  canvas.points = {1};
  EXPECT_FALSE(mouse.press({}, {0, 0}, Qt::NoModifier, Qt::RightButton));
  EXPECT_FALSE(mouse.drag({1, 0}));
  EXPECT_TRUE(chosen().isEmpty());
}

TEST_F(SelectPointsToolTest, SaysWhatIsMissingWithoutAScan) {
  document.setScan(nullptr, {});
  EXPECT_FALSE(mouse.press({}, {0, 0}));
  EXPECT_TRUE(tool.hint().contains("open the scan first"));
}

TEST_F(SelectPointsToolTest, SaysWhatTheMouseAndKeysDo) {
  mouse.hover({}, {0, 0});
  EXPECT_TRUE(tool.hint().contains("Drag: paint points   Shift: add   Alt: take away"));
  EXPECT_FALSE(tool.hint().contains("Del"));
  stroke({1});
  EXPECT_TRUE(tool.hint().contains("{remove} set aside"));
}

/// What is asked of the points when things are clicked, and the answers.
struct ClickedThings : SelectPointsToolTest {
  void SetUp() override {
    SelectPointsToolTest::SetUp();
    QObject::connect(&tool, &SelectPointsTool::asked,
                     [this](const PointQuestion& question, const PointAnswer& answer) {
                       questions.push_back(question);
                       if (isAnswered) answer(found);
                     });
  }

  std::vector<PointQuestion> questions;
  PointSet found = PointSet::of({2, 3});
  bool isAnswered = true;
};

const Eigen::Vector3d here(0.2, 0, 3);
const Eigen::Vector3d there(0.8, 0, 3);

TEST_F(ClickedThings, AreAskedForAndSelected) {
  tool.setThing(PointQuestion::Thing::pole);
  EXPECT_TRUE(tool.hint().startsWith("Click a pole")) << tool.hint().toStdString();
  mouse.click(test::onPoint(here), {0.2, 3});
  ASSERT_EQ(questions.size(), 1);
  EXPECT_EQ(questions[0].thing, PointQuestion::Thing::pole);
  EXPECT_EQ(questions[0].places, std::vector{here});
  EXPECT_EQ(chosen(), found);
  found = PointSet::of({7});
  mouse.click(test::onPoint(there), {0.8, 3}, Qt::ShiftModifier);
  EXPECT_EQ(chosen(), PointSet::of({2, 3, 7}));
  mouse.click(test::onPoint(there), {0.8, 3}, Qt::AltModifier);
  EXPECT_EQ(chosen(), PointSet::of({2, 3}));
}

TEST_F(ClickedThings, NeedTwoClicksForAWire) {
  tool.setThing(PointQuestion::Thing::wire);
  mouse.click(test::onPoint(here), {0.2, 3});
  EXPECT_TRUE(questions.empty());
  EXPECT_TRUE(tool.isBusy());
  mouse.hover(test::onPoint(there), {0.8, 3});
  ASSERT_EQ(canvas.preview.lines.size(), 1);
  EXPECT_EQ(canvas.preview.lines[0], (std::vector{here, there})) << "what it would be";
  mouse.click(test::onPoint(there), {0.8, 3});
  ASSERT_EQ(questions.size(), 1);
  EXPECT_EQ(questions[0].places, (std::vector{here, there}));
  EXPECT_FALSE(tool.isBusy());
  EXPECT_TRUE(canvas.preview.isEmpty());
}

TEST_F(ClickedThings, AreLeftByEscape) {
  tool.setThing(PointQuestion::Thing::wire);
  mouse.click(test::onPoint(here), {0.2, 3});
  tool.cancel();
  EXPECT_FALSE(tool.isBusy());
  EXPECT_TRUE(canvas.preview.isEmpty());
  mouse.click(test::onPoint(there), {0.8, 3});
  EXPECT_TRUE(questions.empty()) << "it begins anew";
}

TEST_F(ClickedThings, AreNoneBesideAllPointsOrAfterADrag) {
  tool.setThing(PointQuestion::Thing::plant);
  EXPECT_THROW(mouse.click({}, {0.2, 3}), Error);
  mouse.press(test::onPoint(here), {0.2, 3});
  EXPECT_FALSE(mouse.drag({2, 3})) << "the camera's";
  mouse.release(test::onPoint(there));
  EXPECT_TRUE(questions.empty());
  EXPECT_TRUE(chosen().isEmpty());
}

TEST_F(ClickedThings, JoinTheSelectionAsItIsWhenTheyAreFound) {
  PointAnswer later;
  isAnswered = false;
  QObject::connect(&tool, &SelectPointsTool::asked,
                   [&later](const PointQuestion&, const PointAnswer& answer) { later = answer; });
  tool.setThing(PointQuestion::Thing::plant);
  mouse.click(test::onPoint(here), {0.2, 3}, Qt::ShiftModifier);
  tool.setShape(Shape::brush);
  stroke({5});
  later(found);
  EXPECT_EQ(chosen(), PointSet::of({2, 3, 5}));
}

} // namespace
} // namespace espalier
