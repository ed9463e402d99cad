#include "ui/panels/option_slider.h"

#include <QTest>
#include <gtest/gtest.h>

namespace espalier {
namespace {

constexpr int middleOfSlider = 10; // of the height [px]

/// A slider of 400 px, shown, its handle in the middleOfSlider and held there.
class HeldSlider : public testing::Test {
protected:
  HeldSlider() {
    slider_.setFixedSize(400, 2 * middleOfSlider);
    slider_.setPlace(0.5);
    slider_.show();
    QTest::mousePress(&slider_, Qt::LeftButton, {}, {200, middleOfSlider});
  }

  void moveTo(int x, Qt::KeyboardModifiers keys) {
    const QPoint place(x, middleOfSlider);
    QMouseEvent move(QEvent::MouseMove, place, slider_.mapToGlobal(place), Qt::NoButton,
                     Qt::LeftButton, keys);
    QCoreApplication::sendEvent(&slider_, &move);
  }

  OptionSlider slider_;
};

TEST_F(HeldSlider, FollowsTheMouse) {
  moveTo(300, Qt::NoModifier);
  EXPECT_NEAR(slider_.place(), 0.75, 0.03); // the handle's own width is not part of its range
}

TEST_F(HeldSlider, MovesATenthAsFarWithShift) {
  moveTo(200, Qt::ShiftModifier);
  moveTo(300, Qt::ShiftModifier);
  EXPECT_NEAR(slider_.place(), 0.525, 0.003);
}

TEST_F(HeldSlider, DoesNotJumpWhenShiftIsReleasedBeforeTheButton) {
  moveTo(200, Qt::ShiftModifier);
  moveTo(300, Qt::ShiftModifier);
  moveTo(310, Qt::NoModifier);
  EXPECT_NEAR(slider_.place(), 0.5275, 0.003);
}

TEST_F(HeldSlider, StaysWithinItsTrack) {
  moveTo(200, Qt::ShiftModifier);
  moveTo(20000, Qt::ShiftModifier);
  EXPECT_DOUBLE_EQ(slider_.place(), 1);
}

} // namespace
} // namespace espalier
