// Fingers and a pen on the view.
#include "tests/support/plants.h"
#include "ui/view/plant_view.h"

#include <QGuiApplication>
#include <QPointingDevice>
#include <QStyleHints>
#include <QTabletEvent>
#include <QTest>
#include <gtest/gtest.h>

#include <gmock/gmock.h>
#include <vector>

namespace espalier {
namespace {

using TouchPhase = ToolInput::Phase;

/// Qt lists it until the program ends: one for all tests.
QPointingDevice* touchScreen() {
  static QPointingDevice* const screen = QTest::createTouchDevice();
  return screen;
}

class TouchTest : public testing::Test {
protected:
  TouchTest() : plant_(test::stick(5)) {
    view_.resize(400, 300);
    view_.setSkeleton(plant_);
    view_.frameAll();
    view_.show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&view_));
    EXPECT_TRUE(QTest::qWaitFor([&] { return view_.isStill(); }));
    view_.setInputHandler([this](const ToolInput& input) {
      inputs_.push_back(input);
      return false;
    });
  }

  [[nodiscard]] std::vector<TouchPhase> phases() const {
    std::vector<TouchPhase> found;
    for (const ToolInput& input : inputs_)
      found.push_back(input.phase);
    return found;
  }
  [[nodiscard]] QPointF pixelOf(NodeId id) const {
    return view_.project(plant_[id].position).value();
  }

  QPointingDevice* screen_ = touchScreen();
  Skeleton plant_;
  PlantView view_;
  std::vector<ToolInput> inputs_;

  void touchOne(const QPointF& from, const QPointF& to) {
    QTest::touchEvent(&view_, screen_).press(0, from.toPoint());
    QTest::touchEvent(&view_, screen_).move(0, ((from + to) / 2).toPoint());
    QTest::touchEvent(&view_, screen_).move(0, to.toPoint());
    QTest::touchEvent(&view_, screen_).release(0, to.toPoint());
  }
  void touchTwo(const QPoint& first, const QPoint& second, const QPoint& firstTo,
                const QPoint& secondTo) {
    QTest::touchEvent(&view_, screen_).press(0, first);
    QTest::touchEvent(&view_, screen_).move(0, first).press(1, second);
    QTest::touchEvent(&view_, screen_).move(0, firstTo).move(1, secondTo);
    QTest::touchEvent(&view_, screen_).release(0, firstTo).move(1, secondTo);
    QTest::touchEvent(&view_, screen_).release(1, secondTo);
  }
};

TEST_F(TouchTest, OfOneFingerTurnsTheCameraAndGoesToNoTool) {
  const Camera before = view_.camera();
  const QPointF node = pixelOf(NodeId{2}); // a mouse would drag it
  touchOne(node, node + QPointF(60, 0));
  EXPECT_NEAR(view_.camera().yaw, before.yaw - 0.42, 0.01);
  EXPECT_EQ(view_.camera().distance, before.distance);
  EXPECT_THAT(inputs_, testing::IsEmpty());
}

TEST_F(TouchTest, OfTwoFingersPansAndZoomsByTheirDistance) {
  const Camera before = view_.camera();
  touchTwo({150, 150}, {250, 150}, {100, 150}, {300, 150});
  EXPECT_NEAR(view_.camera().distance, before.distance / 2, 1e-6) << "twice as far apart";
  EXPECT_EQ(view_.camera().yaw, before.yaw);
  const Camera near = view_.camera();
  const QPointF node = pixelOf(NodeId{2});
  touchTwo({150, 150}, {250, 150}, {150, 190}, {250, 190});
  EXPECT_NEAR(view_.camera().distance, near.distance, 1e-9);
  EXPECT_NEAR(pixelOf(NodeId{2}).y(), node.y() + 40, 0.5) << "the plant goes with the fingers";
  EXPECT_THAT(inputs_, testing::IsEmpty());
}

TEST_F(TouchTest, KeepsThePlaceBetweenTwoFingersWhereItIs) {
  const QPoint node = pixelOf(NodeId{2}).toPoint();
  touchTwo(node - QPoint(40, 0), node + QPoint(40, 0), node - QPoint(80, 0), node + QPoint(80, 0));
  EXPECT_NEAR(pixelOf(NodeId{2}).x(), node.x(), 1);
  EXPECT_NEAR(pixelOf(NodeId{2}).y(), node.y(), 1);
}

TEST_F(TouchTest, IsAClickWhereTheFingerDoesNotMove) {
  const Camera before = view_.camera();
  const QPointF node = pixelOf(NodeId{2});
  touchOne(node, node + QPointF(4, 0));
  EXPECT_EQ(view_.camera(), before);
  ASSERT_THAT(phases(),
              testing::ElementsAre(TouchPhase::hover, TouchPhase::press, TouchPhase::release));
  EXPECT_EQ(inputs_[1].pick.node, NodeId{2});
  EXPECT_EQ(inputs_[1].button, Qt::LeftButton);
  inputs_.clear();
  touchOne(node, node); // a second tap is a double click
  ASSERT_GE(inputs_.size(), 2U);
  EXPECT_EQ(inputs_[1].phase, TouchPhase::doubleClick);
  EXPECT_NEAR((view_.camera().pivot - plant_[NodeId{2}].position).norm(), 0, 1e-9);
}

TEST_F(TouchTest, IsARightClickWhereTheFingerRests) {
  QStyleHints& hints = *QGuiApplication::styleHints();
  const int usual = hints.mousePressAndHoldInterval();
  hints.setMousePressAndHoldInterval(0);
  touchOne({200, 20}, {200, 20});
  hints.setMousePressAndHoldInterval(usual);
  ASSERT_GE(inputs_.size(), 2U);
  EXPECT_EQ(inputs_[1].button, Qt::RightButton);
}

// A hand that rests on the screen while the pen draws.
TEST_F(TouchTest, MovesNothingDuringADrag) {
  view_.setInputHandler([](const ToolInput&) { return true; });
  QTest::mousePress(&view_, Qt::LeftButton, {}, {100, 100});
  const Camera before = view_.camera();
  touchOne({300, 200}, {380, 280});
  EXPECT_EQ(view_.camera(), before);
  QTest::mouseRelease(&view_, Qt::LeftButton, {}, {100, 100});
}

TEST_F(TouchTest, LeavesAPenToQtWhichMakesAMouseOfIt) {
  const QPointingDevice pen("pen", 2, QInputDevice::DeviceType::Stylus,
                            QPointingDevice::PointerType::Pen, QInputDevice::Capability::Position,
                            1, 1);
  for (const QEvent::Type type : {QEvent::TabletPress, QEvent::TabletMove, QEvent::TabletRelease}) {
    QTabletEvent event(type, &pen, {200, 150}, {200, 150}, 0.5, 0, 0, 0, 0, 0, {}, Qt::LeftButton,
                       Qt::LeftButton);
    QCoreApplication::sendEvent(&view_, &event);
    EXPECT_FALSE(event.isAccepted());
  }
}

} // namespace
} // namespace espalier
