#include "tests/ui/view/stick_view.h"
#include "ui/view/clip_handles.h"

#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>

namespace espalier {
namespace {

/// A stick along z, seen from the front; the clip has handles.
class ClipHandlesTest : public test::StickView {
protected:
  ClipHandlesTest() {
    view_.setClipHandlesShown(true);
    view_.setFocus();
  }
  void clipBox() { view_.setClip({.slab = {}, .box = Eigen::AlignedBox3d(low_, high_)}); }
  void clipSlab() { view_.setClip({.slab = Clip::Slab{0.25, 0.75}, .box = {}}); }
  [[nodiscard]] Eigen::AlignedBox3d box() const { return view_.clip().box.value(); }
  [[nodiscard]] Clip::Slab slab() const { return view_.clip().slab.value(); }

  // As a hand does, but between pixels, too.
  void send(QEvent::Type type, const QPointF& place) {
    const bool isMove = type == QEvent::MouseMove;
    QMouseEvent event(type, place, view_.mapToGlobal(place), isMove ? Qt::NoButton : Qt::LeftButton,
                      type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, {});
    QApplication::sendEvent(&view_, &event);
  }
  void drag(const QPointF& from, const QPointF& to) {
    send(QEvent::MouseButtonPress, from);
    send(QEvent::MouseMove, to);
    send(QEvent::MouseButtonRelease, to);
  }
  /// On the gauge, which is 120 high in the middle of the left side of the view.
  [[nodiscard]] static QPointF onGauge(double depth) { return {30, 210 - 120 * depth}; }

  const Eigen::Vector3d low_{-0.5, -0.25, 0.5};
  const Eigen::Vector3d high_{0.5, 0.25, 2.5};
};

TEST_F(ClipHandlesTest, AFaceOfTheBoxFollowsThePointer) {
  clipBox();
  QSignalSpy changes(&view_, &PlantView::clipChanged);
  drag(pixelOf({0, 0, 2.5}), pixelOf({0, 0, 3.25}));
  EXPECT_NEAR(box().max().z(), 3.25, 1e-6);
  EXPECT_EQ(box().min(), low_);
  EXPECT_EQ(changes.count(), 1);
  drag(pixelOf({-0.5, 0, 1.875}), pixelOf({-0.25, 0, 1.875}));
  EXPECT_NEAR(box().min().x(), -0.25, 1e-6) << "its handle is in the middle of the face";
}

TEST_F(ClipHandlesTest, AFaceStopsBeforeTheOther) {
  clipBox();
  drag(pixelOf({0, 0, 2.5}), pixelOf({0, 0, -2}));
  EXPECT_NEAR(box().max().z(), 0.5 + 0.01 * 4, 1e-9) << "a hundredth of the plant is left";
  EXPECT_EQ(box().min(), low_);
}

// The plant is 4 high.
TEST_F(ClipHandlesTest, AFaceGoesLittleBeyondThePlant) {
  clipBox();
  drag(pixelOf({0, 0, 2.5}), pixelOf({0, 0, 30}));
  EXPECT_NEAR(box().max().z(), 4.2, 1e-9);
}

TEST_F(ClipHandlesTest, AFaceTowardTheViewerHasNoHandle) {
  clipBox();
  const Camera before = view_.camera();
  drag(pixelOf({0, -0.25, 1.5}), pixelOf({0, -0.25, 1.9}));
  EXPECT_NE(view_.camera().pitch, before.pitch) << "the drag turns";
  EXPECT_EQ(box().min(), low_);
  EXPECT_EQ(box().max(), high_);
}

TEST_F(ClipHandlesTest, ThePlanesOfTheSlabFollowThePointerOnTheGauge) {
  clipSlab();
  drag(onGauge(0.25), onGauge(0.5));
  EXPECT_NEAR(slab().nearest, 0.5, 1e-9);
  EXPECT_EQ(slab().farthest, 0.75);
  drag(onGauge(0.75), onGauge(2));
  EXPECT_EQ(slab().farthest, 1);
  drag(onGauge(0.5), onGauge(2));
  EXPECT_NEAR(slab().nearest, 0.99, 1e-9) << "it keeps some thickness";
}

TEST_F(ClipHandlesTest, TheSlabMovesAsAWhole) {
  clipSlab();
  drag(onGauge(0.5), onGauge(0.6));
  EXPECT_NEAR(slab().nearest, 0.35, 1e-9);
  EXPECT_NEAR(slab().farthest, 0.85, 1e-9);
  drag(onGauge(0.6), onGauge(2));
  EXPECT_NEAR(slab().nearest, 0.5, 1e-9);
  EXPECT_EQ(slab().farthest, 1);
}

TEST_F(ClipHandlesTest, EscapeInMidDragBringsTheClipBack) {
  clipBox();
  send(QEvent::MouseButtonPress, pixelOf({0, 0, 2.5}));
  send(QEvent::MouseMove, pixelOf({0, 0, 1}));
  EXPECT_NE(box().max(), high_);
  QTest::keyClick(&view_, Qt::Key_Escape);
  EXPECT_EQ(box().max(), high_);
  send(QEvent::MouseMove, pixelOf({0, 0, 1}));
  send(QEvent::MouseButtonRelease, pixelOf({0, 0, 1}));
  EXPECT_EQ(box().max(), high_);
}

TEST_F(ClipHandlesTest, AToolHearsNothingOfADrag) {
  clipBox();
  int presses = 0;
  view_.setInputHandler([&](const ToolInput& input) {
    if (input.phase == ToolInput::Phase::press) ++presses;
    return true;
  });
  drag(pixelOf({0, 0, 2.5}), pixelOf({0, 0, 3}));
  EXPECT_EQ(presses, 0);
  drag(QPointF(5, 5), QPointF(9, 9));
  EXPECT_EQ(presses, 1);
}

TEST_F(ClipHandlesTest, HandlesThatAreNotShownTakeNothing) {
  clipBox();
  const QImage with = view_.grab().toImage();
  view_.setClipHandlesShown(false);
  EXPECT_NE(view_.grab().toImage(), with);
  drag(pixelOf({0, 0, 2.5}), pixelOf({0, 0, 3}));
  EXPECT_EQ(box().max(), high_);
}

} // namespace
} // namespace espalier
