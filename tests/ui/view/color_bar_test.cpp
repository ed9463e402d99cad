#include "tests/ui/view/pictures.h"
#include "ui/view/color_bar.h"
#include "ui/view/plant_view.h"
#include "ui/view/value_field.h"

#include <QApplication>
#include <QMouseEvent>
#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

namespace espalier {
namespace {

/// A block from 0 to 1 high, colored by height: the bar has its handles at 0 and 1.
class ColorBarTest : public testing::Test {
protected:
  ColorBarTest() {
    view_.resize(400, 500);
    view_.setDark(false);
    view_.setPointSize(10); // no gaps
    view_.setCloud(test::block({0, 0, 0.5}));
    view_.frameAll();
    view_.show();
    EXPECT_TRUE(QTest::qWaitFor([&] { return view_.isStill(); }));
    bar_ = view_.findChild<ColorBar*>();
    view_.setFocus();
  }

  /// Of a height of the bar, on the bar or at its number; the bar keeps 10 pixels on each side.
  [[nodiscard]] QPoint at(double part) const {
    return {bar_->width() - 16, int(std::lround(bar_->height() - 10 - part * length()))};
  }
  [[nodiscard]] QPoint numberAt(double part) const { return {30, at(part).y()}; }
  [[nodiscard]] double length() const { return bar_->height() - 20; }

  void press(const QPoint& place) { QTest::mousePress(bar_, Qt::LeftButton, {}, place); }
  void release(const QPoint& place) { QTest::mouseRelease(bar_, Qt::LeftButton, {}, place); }
  void drag(double from, double to) {
    press(at(from));
    moveTo(to);
    release(at(to));
  }
  void moveTo(double part) {
    const QPointF place = at(part);
    QMouseEvent move(QEvent::MouseMove, place, bar_->mapToGlobal(place), Qt::NoButton,
                     Qt::LeftButton, {});
    QApplication::sendEvent(bar_, &move);
  }
  [[nodiscard]] std::optional<ValueRange> chosen() const {
    const auto& ranges = view_.colorScales().ranges;
    const auto range = ranges.find("color_height");
    return range != ranges.end() ? std::optional(range->second) : std::nullopt;
  }
  void typeAt(double part, const QString& text, Qt::Key end) {
    press(numberAt(part));
    release(numberAt(part));
    auto* field = view_.findChild<ValueField*>();
    ASSERT_NE(field, nullptr);
    QTest::keyClicks(field, text);
    QTest::keyClick(field, end);
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }

  PlantView view_;
  ColorBar* bar_ = nullptr;
};

TEST_F(ColorBarTest, AHandleSetsItsEndOfTheRange) {
  QSignalSpy changes(&view_, &PlantView::colorScalesChanged);
  EXPECT_FALSE(chosen());
  drag(1, 0.5);
  ASSERT_TRUE(chosen());
  EXPECT_NEAR(chosen()->to, 0.5, 2 / length());
  EXPECT_NEAR(chosen()->from, 0, 1e-6);
  EXPECT_EQ(changes.count(), 1) << "once, when it is let go";
  drag(0, 0.25);
  EXPECT_NEAR(chosen()->from, 0.25, 2 / length());
}

TEST_F(ColorBarTest, AHandleStopsBeforeTheOther) {
  drag(1, -0.5);
  EXPECT_NEAR(chosen()->to, 0.01, 1e-6);
  EXPECT_GT(chosen()->to, chosen()->from);
}

TEST_F(ColorBarTest, EscapeInMidDragBringsTheRangeBack) {
  press(at(1));
  moveTo(0.5);
  EXPECT_TRUE(chosen());
  QTest::keyClick(&view_, Qt::Key_Escape);
  EXPECT_FALSE(chosen());
  moveTo(0.3);
  release(at(0.3));
  EXPECT_FALSE(chosen());
}

TEST_F(ColorBarTest, ADoubleClickGivesTheUsualRangeBack) {
  drag(1, 0.5);
  QTest::mouseDClick(bar_, Qt::LeftButton, {}, at(0.2));
  EXPECT_FALSE(chosen());
}

TEST_F(ColorBarTest, TakesTypedEndsBeyondAllValues) {
  typeAt(1, "2,5", Qt::Key_Return);
  ASSERT_TRUE(chosen());
  EXPECT_EQ(chosen()->to, 2.5);
  typeAt(0, "-1", Qt::Key_Return);
  EXPECT_EQ(chosen(), (ValueRange{-1, 2.5}));
  EXPECT_EQ(view_.findChild<ValueField*>(), nullptr);
}

TEST_F(ColorBarTest, TabGoesOnToTheOtherEnd) {
  typeAt(1, "3", Qt::Key_Tab);
  auto* field = view_.findChild<ValueField*>();
  ASSERT_NE(field, nullptr);
  QTest::keyClicks(field, "1");
  QTest::keyClick(field, Qt::Key_Enter);
  EXPECT_EQ(chosen(), (ValueRange{1, 3}));
}

TEST_F(ColorBarTest, RefusesWhatIsNoRange) {
  typeAt(1, "tall", Qt::Key_Return);
  EXPECT_FALSE(chosen());
  typeAt(1, "-2", Qt::Key_Return);
  EXPECT_FALSE(chosen());
  typeAt(1, "5", Qt::Key_Escape);
  EXPECT_FALSE(chosen());
  typeAt(1, "", Qt::Key_Return); // nothing typed: as it was
  EXPECT_FALSE(chosen());
}

TEST_F(ColorBarTest, ValuesBeyondTheRangeTakeTheEndColors) {
  view_.setColorScales({.ranges = {{"color_height", {5, 6}}}});
  const QImage low = view_.grab().toImage();
  const Color first = colorOf(ColorMap::viridis, 0, false);
  EXPECT_GT(test::countPixels(low, {100, 250}, 15, first, 60), 300);
  view_.setColorScales({.ranges = {{"color_height", {-6, -5}}}});
  const Color last = colorOf(ColorMap::viridis, 1, false);
  EXPECT_GT(test::countPixels(view_.grab().toImage(), {100, 250}, 15, last, 60), 300);
}

TEST_F(ColorBarTest, LeavesWhatIsBetweenTheHandlesToTheView) {
  const Camera before = view_.camera();
  const QPoint from = bar_->mapTo(&view_, at(0.5));
  QTest::mousePress(bar_, Qt::LeftButton, {}, at(0.5));
  moveTo(0.2);
  release(at(0.2));
  EXPECT_NE(view_.camera().pitch, before.pitch) << "a drag there turns, from " << from.y();
  EXPECT_FALSE(chosen());
}

TEST_F(ColorBarTest, GoesWithTheColors) {
  EXPECT_TRUE(bar_->isVisible());
  view_.setPointColor(PointColor::uniform);
  EXPECT_FALSE(bar_->isVisible());
  EXPECT_FALSE(view_.typeColorRange());
  view_.setPointColor(PointColor::height);
  EXPECT_TRUE(bar_->isVisible());
  EXPECT_TRUE(view_.typeColorRange());
}

} // namespace
} // namespace espalier
