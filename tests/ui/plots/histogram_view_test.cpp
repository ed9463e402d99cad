#include "ui/plots/histogram_view.h"

#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

#include <limits>
#include <numeric>

namespace espalier {
namespace {

/// 0, 1, ... 999: as many in each bin.
std::vector<float> thousand() {
  std::vector<float> values(1000);
  std::iota(values.begin(), values.end(), 0.0F);
  return values;
}

/// A histogram of 420 x 120 px: 400 px for the values from 0 to 999.
class ShownHistogram : public testing::Test {
protected:
  ShownHistogram() {
    view_.resize(420, 120);
    view_.show({.values = thousand(), .title = "Residual", .unit = "mm", .range = {}});
    view_.QWidget::show();
  }

  void moveTo(int x, Qt::KeyboardModifiers keys = Qt::NoModifier) {
    const QPoint place(x, 60);
    QMouseEvent move(QEvent::MouseMove, place, view_.mapToGlobal(place), Qt::NoButton,
                     Qt::LeftButton, keys);
    QCoreApplication::sendEvent(&view_, &move);
  }

  void drag(int from, int to) {
    QTest::mousePress(&view_, Qt::LeftButton, {}, {from, 60});
    moveTo(to);
    QTest::mouseRelease(&view_, Qt::LeftButton, {}, {to, 60});
  }

  HistogramView view_;
  QSignalSpy brushed_{&view_, &HistogramView::brushed};
  QSignalSpy cleared_{&view_, &HistogramView::brushCleared};
};

TEST_F(ShownHistogram, MarksWhatADragGoesOver) {
  drag(110, 210);
  ASSERT_EQ(brushed_.size(), 2);
  EXPECT_FALSE(brushed_[0][2].toBool()) << "in mid-drag";
  EXPECT_TRUE(brushed_[1][2].toBool());
  EXPECT_NEAR(brushed_[1][0].toDouble(), 999 * 0.25, 1);
  EXPECT_NEAR(brushed_[1][1].toDouble(), 999 * 0.5, 1);
  EXPECT_EQ(view_.plot().brush->count, 250U) << "of 1000 in a quarter";
  EXPECT_TRUE(view_.plot().brushText().contains("250 (25"))
      << view_.plot().brushText().toStdString();
  EXPECT_TRUE(view_.plot().brushText().contains("mm"));
}

TEST_F(ShownHistogram, MarksBackwardToo) {
  drag(210, 110);
  EXPECT_LT(brushed_.last()[0].toDouble(), brushed_.last()[1].toDouble());
}

TEST_F(ShownHistogram, MovesAnEndThatIsGripped) {
  drag(110, 210);
  drag(211, 310);
  EXPECT_NEAR(brushed_.last()[0].toDouble(), 999 * 0.25, 1) << "the other end stays";
  EXPECT_NEAR(brushed_.last()[1].toDouble(), 999 * 0.75, 1);
}

TEST_F(ShownHistogram, IsClearedByAClickAndByEscape) {
  drag(110, 210);
  QTest::mouseClick(&view_, Qt::LeftButton, {}, {300, 60});
  EXPECT_EQ(cleared_.size(), 1);
  EXPECT_FALSE(view_.plot().brush);
  drag(110, 210);
  QTest::keyClick(&view_, Qt::Key_Escape);
  EXPECT_EQ(cleared_.size(), 2);
  QTest::mouseClick(&view_, Qt::LeftButton, {}, {300, 60});
  EXPECT_EQ(cleared_.size(), 2) << "nothing is there to be cleared";
}

TEST_F(ShownHistogram, LeavesADragByEscapeAsItWas) {
  drag(110, 210);
  QTest::mousePress(&view_, Qt::LeftButton, {}, {300, 60});
  moveTo(400);
  QTest::keyClick(&view_, Qt::Key_Escape);
  QTest::mouseRelease(&view_, Qt::LeftButton, {}, {400, 60});
  EXPECT_EQ(cleared_.size(), 0);
  EXPECT_NEAR(brushed_.last()[0].toDouble(), 999 * 0.25, 1);
  EXPECT_TRUE(brushed_.last()[2].toBool());
}

TEST_F(ShownHistogram, TakesTheMouseFinelyWithShift) {
  QTest::mousePress(&view_, Qt::LeftButton, {}, {110, 60});
  moveTo(210);
  moveTo(310, Qt::ShiftModifier);
  EXPECT_NEAR(brushed_.last()[1].toDouble(), 999 * 0.525, 1) << "10 px for 100";
}

TEST_F(ShownHistogram, IsMovedAndWidenedByKeys) {
  drag(110, 210);
  const double bin = view_.plot().bins.width();
  const double from = view_.plot().brush->from;
  const double to = view_.plot().brush->to;
  QTest::keyClick(&view_, Qt::Key_Right);
  EXPECT_NEAR(view_.plot().brush->from, from + bin, 1e-9);
  EXPECT_NEAR(view_.plot().brush->to, to + bin, 1e-9);
  QTest::keyClick(&view_, Qt::Key_Left, Qt::ShiftModifier);
  EXPECT_NEAR(view_.plot().brush->from, from + 0.9 * bin, 1e-9);
  QTest::keyClick(&view_, Qt::Key_Up);
  EXPECT_NEAR(view_.plot().brush->from, from - 0.1 * bin, 1e-9);
  EXPECT_NEAR(view_.plot().brush->to, to + 1.9 * bin, 1e-9);
  QTest::keyClick(&view_, Qt::Key_Down);
  EXPECT_NEAR(view_.plot().brush->to, to + 0.9 * bin, 1e-9);
  for (int i = 0; i < 100; ++i)
    QTest::keyClick(&view_, Qt::Key_Right);
  EXPECT_NEAR(view_.plot().brush->to, 999, 1e-9) << "no farther than there are values";
  EXPECT_NEAR(view_.plot().brush->to - view_.plot().brush->from, to - from, 1e-9);
  for (int i = 0; i < 100; ++i)
    QTest::keyClick(&view_, Qt::Key_Down);
  EXPECT_GT(view_.plot().brush->to, view_.plot().brush->from);
}

TEST_F(ShownHistogram, IsMarkedByKeysAlone) {
  QTest::keyClick(&view_, Qt::Key_Right);
  ASSERT_TRUE(view_.plot().brush);
  EXPECT_EQ(view_.plot().brush->count, 334U) << "the middle third, 333 to 666";
  EXPECT_TRUE(view_.accessibleDescription().contains("334"));
}

TEST_F(ShownHistogram, ReportsABrushThatAHeldKeyMovesAsNotFinal) {
  QTest::keyPress(&view_, Qt::Key_Right);
  QKeyEvent held(QEvent::KeyPress, Qt::Key_Right, Qt::NoModifier, {}, true);
  QCoreApplication::sendEvent(&view_, &held);
  EXPECT_FALSE(brushed_.last()[2].toBool());
  QTest::keyRelease(&view_, Qt::Key_Right);
  EXPECT_TRUE(brushed_.last()[2].toBool());
}

TEST_F(ShownHistogram, KeepsTheBrushForOtherValuesOfTheSameKind) {
  drag(110, 210);
  view_.show({.values = {300, 301, 2000}, .title = "Residual", .unit = "mm", .range = {}});
  ASSERT_TRUE(view_.plot().brush);
  EXPECT_EQ(view_.plot().brush->count, 2U);
  view_.show({.values = {300, 301, 2000}, .title = "Density", .unit = {}, .range = {}});
  EXPECT_FALSE(view_.plot().brush);
}

TEST_F(ShownHistogram, MarksAllThatLiesBeyondWithTheLastBar) {
  std::vector<float> values = thousand();
  values.insert(values.end(), 3, 1e6F);
  view_.show({.values = values, .title = "Residual", .unit = "mm", .range = {}});
  drag(200, 417);
  EXPECT_EQ(brushed_.last()[1].toDouble(), 1e6);
  EXPECT_TRUE(view_.plot().tipAt({405, 60}, view_.rect()).contains(": 5 of"))
      << "998, 999 and three far beyond: "
      << view_.plot().tipAt({405, 60}, view_.rect()).toStdString();
}

TEST_F(ShownHistogram, PaintsMarkedBarsInAnotherColorThanTheOthers) {
  drag(110, 210);
  for (const bool isDark : {false, true}) {
    view_.setDark(isDark);
    const QImage image = view_.grab().toImage();
    const QColor chosen = plotColors(isDark).chosen;
    EXPECT_EQ(image.pixelColor(160, 80), chosen);
    EXPECT_NE(image.pixelColor(300, 80), chosen);
    EXPECT_NE(image.pixelColor(300, 80), image.pixelColor(300, 15)) << "there is a bar, too";
  }
}

TEST_F(ShownHistogram, DrawsASecondSetOfAnotherSizeAsHighAsItsShare) {
  view_.addSecond({1, 1, 1, 1}, "B"); // all in one bin
  const HistogramPlot& plot = view_.plot();
  ASSERT_TRUE(plot.second);
  EXPECT_EQ(plot.second->counts.size(), plot.bins.counts.size());
  EXPECT_TRUE(plot.tipAt({12, 60}, view_.rect()).contains("B: 4 of 4"))
      << plot.tipAt({12, 60}, view_.rect()).toStdString();
  const QImage image = view_.grab().toImage();
  EXPECT_NE(image.pixelColor(300, 96), image.pixelColor(300, 40)) << "bars, a twentieth as high";
  view_.addSecond({});
  EXPECT_FALSE(plot.second);
}

TEST_F(ShownHistogram, MarksANumberThatIsShownElsewhere) {
  const PlottedValues plain{.values = thousand(), .title = "Residual", .unit = "mm", .range = {}};
  const auto dark = [&](double value) {
    const QImage image = view_.grab().toImage();
    const int x = static_cast<int>(std::lround(view_.plot().placeOf(value, view_.rect())));
    int count = 0;
    for (int y = 24; y < view_.height() - 24; ++y)
      count += static_cast<int>(qGray(image.pixel(x, y)) < 100);
    return count;
  };
  view_.show(plain);
  const int before = dark(700);
  PlottedValues marked = plain;
  marked.mark = {.value = 700, .text = "median 700"};
  view_.show(marked);
  EXPECT_GT(dark(700), before + 20) << "a dashed line over the bars";
  EXPECT_EQ(view_.plot().mark->text, "median 700");
}

TEST_F(ShownHistogram, ShowsTheNewTitleBeforeTheValues) {
  view_.show({.values = {}, .title = "Density", .unit = {}, .range = {}, .areComing = true});
  EXPECT_EQ(view_.plot().title, "Density");
  EXPECT_EQ(view_.accessibleDescription(), "Computing…");
}

TEST_F(ShownHistogram, SaysThatThereIsNothing) {
  view_.show({.values = {std::numeric_limits<float>::quiet_NaN()},
              .title = "Residual",
              .unit = {},
              .range = {}});
  drag(110, 210);
  QTest::keyClick(&view_, Qt::Key_Right);
  view_.addSecond({1, 2, 3});
  EXPECT_FALSE(view_.grab().isNull());
  EXPECT_EQ(brushed_.size(), 0);
  EXPECT_EQ(view_.accessibleDescription(), "No values");
}

} // namespace
} // namespace espalier
