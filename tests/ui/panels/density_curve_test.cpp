#include "ui/panels/density_curve.h"

#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>
#include <gtest/gtest.h>

#include <cmath>

namespace espalier {
namespace {

using Curve = DensityCurve::Curve;

TEST(DensityCurve, RaisesTheRadiusFromLeastToMostByAPower) {
  const Curve curve{.least = 2, .most = 10, .exponent = 3};
  EXPECT_DOUBLE_EQ(curve.radiusAt(0), 2);
  EXPECT_DOUBLE_EQ(curve.radiusAt(0.5), 3); // 2 + 8 / 8
  EXPECT_DOUBLE_EQ(curve.radiusAt(1), 10);
}

/// A curve of 266 x 142 px from 4 to 10 mm, of points 2 mm apart: within its axes, 200 x 100 px,
/// 1 px is 0.135 mm, as the axis ends at 1.35 times the greatest radius.
class ShownCurve : public testing::Test {
protected:
  ShownCurve() {
    curve_.resize(266, 142);
    curve_.setLimits({.least = 1, .exponent = 0.1}, {.most = 100, .exponent = 10}, "mm", 2);
    curve_.setDefault({.least = 4, .most = 10, .exponent = 1});
    curve_.setCurve({.least = 4, .most = 10, .exponent = 1});
    curve_.show();
  }

  static QPoint placeOf(double density, double radius, double top = 13.5) {
    return {static_cast<int>(std::lround(36 + 200 * density)),
            static_cast<int>(std::lround(122 - 100 * radius / top))};
  }
  void moveTo(const QPoint& place, Qt::KeyboardModifiers keys = Qt::NoModifier) {
    QMouseEvent move(QEvent::MouseMove, place, curve_.mapToGlobal(place), Qt::NoButton,
                     Qt::LeftButton, keys);
    QCoreApplication::sendEvent(&curve_, &move);
  }
  void drag(const QPoint& from, const QPoint& to) {
    QTest::mousePress(&curve_, Qt::LeftButton, {}, from);
    moveTo(to);
    QTest::mouseRelease(&curve_, Qt::LeftButton, {}, to);
  }

  DensityCurve curve_;
  QSignalSpy changed_{&curve_, &DensityCurve::changed};
};

TEST_F(ShownCurve, SetsTheRadiiWithTheHandlesAtItsEnds) {
  drag(placeOf(0, 4), placeOf(0, 8));
  EXPECT_NEAR(curve_.curve().least, 8, 0.2);
  drag(placeOf(1, 10), placeOf(1, 12));
  EXPECT_NEAR(curve_.curve().most, 12, 0.2);
  EXPECT_EQ(curve_.curve().exponent, 1);
  EXPECT_EQ(changed_.size(), 2);
}

TEST_F(ShownCurve, BendsThroughTheHandleInTheMiddle) {
  drag(placeOf(0.5, 7), placeOf(0.5, 5.5)); // a quarter of the rise at half of the density
  EXPECT_NEAR(curve_.curve().exponent, 2, 0.1);
  EXPECT_NEAR(curve_.curve().radiusAt(0.5), 5.5, 0.15) << "it lies where it was dragged to";
  EXPECT_EQ(curve_.curve().least, 4);
  EXPECT_EQ(curve_.curve().most, 10);
  drag(placeOf(0.5, 5.5), placeOf(0.5, 60));
  EXPECT_EQ(curve_.curve().exponent, 0.1);
}

TEST_F(ShownCurve, KeepsTheRadiiInOrderAndWithinTheirLimits) {
  drag(placeOf(0, 4), placeOf(0, 40));
  EXPECT_EQ(curve_.curve().least, 10) << "not above the greatest";
  drag(placeOf(0, 10), placeOf(0, -40));
  EXPECT_EQ(curve_.curve().least, 1);
  drag(placeOf(1, 10), placeOf(1, 900));
  EXPECT_EQ(curve_.curve().most, 100);
}

TEST_F(ShownCurve, FollowsTheMouseFinelyWithShift) {
  QTest::mousePress(&curve_, Qt::LeftButton, {}, placeOf(1, 10));
  moveTo(placeOf(1, 10) - QPoint(0, 20), Qt::ShiftModifier); // as 2 px: 0.27 mm
  EXPECT_NEAR(curve_.curve().most, 10.27, 0.1);
}

TEST_F(ShownCurve, IsAsBeforeAfterEscapeInADrag) {
  QTest::mousePress(&curve_, Qt::LeftButton, {}, placeOf(1, 10));
  moveTo(placeOf(1, 12));
  EXPECT_GT(curve_.curve().most, 10);
  QTest::keyClick(&curve_, Qt::Key_Escape);
  EXPECT_EQ(curve_.curve().most, 10);
  EXPECT_EQ(changed_.size(), 2) << "and who follows it is notified";
}

TEST_F(ShownCurve, GoesBackToTheDefaultByADoubleClick) {
  curve_.setCurve({.least = 5, .most = 9, .exponent = 2});
  QTest::mouseDClick(&curve_, Qt::LeftButton, {}, placeOf(1, 9));
  EXPECT_EQ(curve_.curve(), (Curve{.least = 5, .most = 10, .exponent = 2}));
  QTest::mouseDClick(&curve_, Qt::LeftButton, {}, placeOf(0, 5));
  EXPECT_EQ(curve_.curve(), (Curve{.least = 4, .most = 10, .exponent = 2}));
  QTest::mouseDClick(&curve_, Qt::LeftButton, {}, placeOf(0.5, 5.5));
  EXPECT_EQ(curve_.curve(), (Curve{.least = 4, .most = 10, .exponent = 1}));
}

TEST_F(ShownCurve, NotifiesNobodyOfWhatItIsGiven) {
  curve_.setCurve({.least = 5, .most = 9, .exponent = 2});
  EXPECT_EQ(changed_.size(), 0);
}

TEST_F(ShownCurve, IsSetByKeysFromHandleToHandle) {
  QTest::keyClick(&curve_, Qt::Key_Up);
  EXPECT_NEAR(curve_.curve().least, 4.2, 1e-9) << "a round step, a fiftieth of the axis";
  QTest::keyClick(&curve_, Qt::Key_Down, Qt::ShiftModifier);
  EXPECT_NEAR(curve_.curve().least, 4.18, 1e-9);
  curve_.activateWindow();
  curve_.setFocus();
  ASSERT_TRUE(QTest::qWaitFor([&] { return curve_.hasFocus(); }));
  QTest::keyClick(&curve_, Qt::Key_Tab);
  QTest::keyClick(&curve_, Qt::Key_Down);
  EXPECT_NEAR(curve_.curve().exponent, 1.1, 1e-9) << "less radius amid the densities";
  QTest::keyClick(&curve_, Qt::Key_Up, Qt::ShiftModifier);
  EXPECT_LT(curve_.curve().exponent, 1.1);
  QTest::keyClick(&curve_, Qt::Key_Tab);
  QTest::keyClick(&curve_, Qt::Key_Right);
  EXPECT_NEAR(curve_.curve().most, 10.2, 1e-9);
  EXPECT_EQ(changed_.size(), 5);
}

TEST_F(ShownCurve, NamesWhatMovesToThoseWhoDoNotSeeIt) {
  EXPECT_TRUE(curve_.accessibleDescription().startsWith("Least 4.00"));
  EXPECT_TRUE(curve_.accessibleDescription().contains("mm = 2.00 spacings"));
  QTest::keyClick(&curve_, Qt::Key_Up);
  EXPECT_TRUE(curve_.accessibleDescription().startsWith("Least 4.20"))
      << curve_.accessibleDescription().toStdString();
}

TEST(DensityCurve, LetsTabOutAfterItsLastHandle) {
  QWidget window;
  auto* column = new QVBoxLayout(&window);
  auto* curve = new DensityCurve;
  auto* after = new QLineEdit;
  column->addWidget(curve);
  column->addWidget(after);
  window.show();
  window.activateWindow();
  curve->setFocus(Qt::TabFocusReason);
  ASSERT_TRUE(QTest::qWaitFor([&] { return curve->hasFocus(); }));
  QTest::keyClick(curve, Qt::Key_Tab);
  QTest::keyClick(curve, Qt::Key_Tab);
  EXPECT_TRUE(curve->hasFocus());
  QTest::keyClick(curve, Qt::Key_Tab);
  EXPECT_TRUE(after->hasFocus());
}

TEST_F(ShownCurve, ShowsTheDensitiesBehindIt) {
  const QImage without = curve_.grab().toImage();
  curve_.setDensities({0.9F, 0.92F, 0.91F, 0.1F, std::nanf("")});
  const QImage with = curve_.grab().toImage();
  const QPoint dense = placeOf(0.92, 1);
  EXPECT_NE(with.pixelColor(dense), without.pixelColor(dense));
  const QPoint empty = placeOf(0.55, 1);
  EXPECT_EQ(with.pixelColor(empty), without.pixelColor(empty));
}

} // namespace
} // namespace espalier
