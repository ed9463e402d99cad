#include "tests/app/window/window_fixture.h"

#include <QAction>
#include <QApplication>
#include <QMouseEvent>
#include <QTest>
#include <QUndoStack>

#include <gmock/gmock.h>
#include <numbers>

namespace espalier {
namespace {

constexpr double quarterTurn = std::numbers::pi / 2;

class TwoViewsTest : public test::WindowTest {
protected:
  TwoViewsTest() {
    open({writeFork("fork.mtg")});
    key(Qt::Key_F12);
    waitForBoth();
  }
  [[nodiscard]] PlantView* maybeSecond() { return window().findChild<PlantView*>("second_view"); }
  [[nodiscard]] PlantView& second() { return find<PlantView>("second_view"); }
  void waitForBoth() {
    waitForView();
    ASSERT_TRUE(QTest::qWaitFor([&] { return second().isStill(); }, patience));
  }
  /// How far the second view is turned from the first.
  [[nodiscard]] double turn() {
    return std::remainder(second().camera().yaw - view().camera().yaw, 2 * std::numbers::pi);
  }
  void turnByHand(PlantView& of) {
    const QPoint corner(8, of.height() / 2);
    QTest::mousePress(&of, Qt::LeftButton, Qt::ControlModifier, corner);
    QTest::mouseMove(&of, corner + QPoint(50, 0));
    QTest::mouseRelease(&of, Qt::LeftButton, Qt::ControlModifier, corner + QPoint(50, 0));
  }
  [[nodiscard]] QPoint inSecond(NodeId id) {
    return second().project(document().skeleton()[id].position).value().toPoint();
  }
};

TEST_F(TwoViewsTest, TheSecondLooksFromTheSideAndMovesWithTheFirst) {
  EXPECT_NEAR(turn(), quarterTurn, 1e-9);
  const double yaw = view().camera().yaw;
  turnByHand(view());
  EXPECT_NE(view().camera().yaw, yaw);
  EXPECT_NEAR(turn(), quarterTurn, 1e-9);
  action("view_top").trigger();
  waitForBoth();
  EXPECT_NEAR(second().camera().pitch, quarterTurn, 1e-9);
}

TEST_F(TwoViewsTest, WhatFilledOneViewIsSeenInHalfOfIt) {
  key(Qt::Key_F12);
  document().edit("Wide", [&](SkeletonEditor& editor) {
    editor.setPosition(nodeAt({1, 0, 2}), {6, 0, 1});
  });
  action("frame_all").trigger();
  waitForView();
  key(Qt::Key_F12);
  waitForBoth();
  const QPointF at = view().project({6, 0, 1}).value();
  EXPECT_TRUE(view().rect().contains(at.toPoint())) << at.x() << " of " << view().width();
}

TEST_F(TwoViewsTest, TheFirstMovesWithTheSecond) {
  const double yaw = view().camera().yaw;
  turnByHand(second());
  EXPECT_NE(view().camera().yaw, yaw);
  EXPECT_NEAR(turn(), quarterTurn, 1e-9);
}

TEST_F(TwoViewsTest, TheyLookAsTheyAreLinked) {
  action("link_same").trigger();
  EXPECT_EQ(second().camera(), view().camera());
  action("link_free").trigger();
  turnByHand(second());
  const Camera of = second().camera();
  EXPECT_NE(of, view().camera());
  turnByHand(view());
  EXPECT_EQ(second().camera(), of);
  restart();
  EXPECT_TRUE(action("link_free").isChecked()) << "it is remembered";
}

TEST_F(TwoViewsTest, TheSecondIsRememberedUntilItIsSwitchedOff) {
  restart();
  EXPECT_TRUE(action("two_views").isChecked());
  ASSERT_NE(maybeSecond(), nullptr);
  open({writeFork("fork.mtg")});
  EXPECT_TRUE(second().isVisible());
  EXPECT_NEAR(second().width(), view().width(), 2);
  key(Qt::Key_F12);
  restart();
  EXPECT_EQ(maybeSecond(), nullptr);
}

TEST_F(TwoViewsTest, TheSecondShowsAllOfThePlantWhileTheFirstLooksClosely) {
  action("link_whole").trigger();
  waitForBoth();
  EXPECT_LT(second().width(), view().width());
  const Camera whole = second().camera();
  const NodeId apex = nodeAt({1, 0, 2});
  const QPoint at = inSecond(apex);
  QMouseEvent move(QEvent::MouseMove, QPointF(at), QPointF(second().mapToGlobal(at)), Qt::NoButton,
                   Qt::NoButton, Qt::NoModifier);
  QApplication::sendEvent(&second(), &move);
  const Camera before = view().camera();
  key(Qt::Key_Z);
  waitForBoth();
  EXPECT_EQ(second().camera(), whole);
  EXPECT_NE(view().camera(), before);
  EXPECT_TRUE(view().pick(*view().project({1, 0, 2})).node == apex);
  key(Qt::Key_Z, Qt::ShiftModifier);
  waitForBoth();
  EXPECT_EQ(view().camera(), before);
}

TEST_F(TwoViewsTest, AToolWorksInTheSecondToo) {
  const NodeId apex = nodeAt({1, 0, 2});
  action("link_free").trigger();
  second().setCamera(view().camera()); // from the side, another shoot would hide it
  ASSERT_TRUE(QTest::qWaitFor([&] { return second().isStill(); }, patience));
  const Skeleton before = document().skeleton();
  action("tool_move").trigger();
  const QPoint from = inSecond(apex);
  QTest::mousePress(&second(), Qt::LeftButton, {}, from);
  QTest::mouseMove(&second(), from + QPoint(0, -30));
  QTest::mouseRelease(&second(), Qt::LeftButton, {}, from + QPoint(0, -30));
  EXPECT_GT(document().skeleton()[apex].position.z(), before[apex].position.z());
  EXPECT_NEAR(document().skeleton()[apex].position.x(), before[apex].position.x(), 0.05);
  EXPECT_EQ(document().undoStack().count(), 1);
  key(Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document().skeleton(), before);
}

TEST_F(TwoViewsTest, EscapeInTheSecondBringsThePlantBack) {
  const NodeId root = nodeAt({0, 0, 0});
  const Skeleton before = document().skeleton();
  action("tool_move").trigger();
  const QPoint from = inSecond(root);
  QTest::mousePress(&second(), Qt::LeftButton, {}, from);
  QTest::mouseMove(&second(), from + QPoint(40, 0));
  EXPECT_NE(document().skeleton(), before);
  QTest::keyClick(&second(), Qt::Key_Escape);
  EXPECT_EQ(document().skeleton(), before);
  QTest::mouseRelease(&second(), Qt::LeftButton, {}, from + QPoint(40, 0));
  EXPECT_EQ(document().skeleton(), before);
}

TEST_F(TwoViewsTest, ABoxInTheSecondTakesWhatIsInItThere) {
  const QPoint root = inSecond(nodeAt({0, 0, 0}));
  const QPoint reach(15, 15);
  QTest::mousePress(&second(), Qt::LeftButton, Qt::ShiftModifier, root - reach);
  QTest::mouseMove(&second(), root + reach);
  QTest::mouseRelease(&second(), Qt::LeftButton, Qt::ShiftModifier, root + reach);
  EXPECT_THAT(document().selection().nodes(), testing::ElementsAre(nodeAt({0, 0, 0})));
}

TEST_F(TwoViewsTest, OneViewIsLeftWhenTheSecondIsSwitchedOff) {
  const NodeId root = nodeAt({0, 0, 0});
  QTest::mouseClick(&second(), Qt::LeftButton, {}, inSecond(root));
  EXPECT_THAT(document().selection().nodes(), testing::ElementsAre(root));
  key(Qt::Key_F12);
  EXPECT_EQ(maybeSecond(), nullptr);
  const NodeId top = nodeAt({0, 0, 1});
  click(placeOf(top));
  EXPECT_THAT(document().selection().nodes(), testing::ElementsAre(top));
}

} // namespace
} // namespace espalier
