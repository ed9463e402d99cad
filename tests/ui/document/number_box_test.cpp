#include "ui/document/number_box.h"

#include <QSignalSpy>
#include <QTest>
#include <QToolTip>
#include <gtest/gtest.h>

namespace espalier {
namespace {

class NumberBoxTest : public testing::Test {
protected:
  NumberBoxTest() {
    box_.setKeyboardTracking(false);
    box_.setDecimals(4);
    box_.setRange(0, 0.6);
    box_.setValue(0.25);
    setUnit("m");
    box_.show();
  }
  void setUnit(const QString& unit) {
    box_.setSuffix(unit.isEmpty() ? unit : QChar(0x202f) + unit);
  }
  double typed(const QString& text) {
    box_.selectAll();
    QTest::keyClicks(&box_, text);
    QTest::keyClick(&box_, Qt::Key_Return);
    return box_.value();
  }

  NumberBox box_;
};

TEST_F(NumberBoxTest, TakesLengthsInOtherUnits) {
  EXPECT_DOUBLE_EQ(typed("3 cm"), 0.03);
  EXPECT_EQ(box_.text(), QString("0.0300\u202fm")) << "written in that of the plant";
  EXPECT_DOUBLE_EQ(typed("45mm"), 0.045);
  EXPECT_DOUBLE_EQ(typed("0.5 m"), 0.5);
  EXPECT_DOUBLE_EQ(typed("0,125"), 0.125);
  setUnit("mm");
  box_.setRange(0, 600);
  EXPECT_DOUBLE_EQ(typed("0.05m"), 50);
  EXPECT_DOUBLE_EQ(typed("4.5"), 4.5);
}

TEST_F(NumberBoxTest, ReportsAValueOnceItIsTyped) {
  const QSignalSpy changed(&box_, &QDoubleSpinBox::valueChanged);
  typed("30 mm");
  ASSERT_EQ(changed.count(), 1);
  EXPECT_DOUBLE_EQ(changed.front().front().toDouble(), 0.03);
}

TEST_F(NumberBoxTest, TakesTheNearestThatIsInTheRange) {
  EXPECT_DOUBLE_EQ(typed("5"), 0.6);
  EXPECT_DOUBLE_EQ(typed("3 m"), 0.6);
  EXPECT_DOUBLE_EQ(typed("-1"), 0);
}

TEST_F(NumberBoxTest, KeepsItsValueIfWhatIsTypedIsNotComplete) {
  EXPECT_DOUBLE_EQ(typed("3 c"), 0.25);
  EXPECT_DOUBLE_EQ(typed("-"), 0.25);
  EXPECT_DOUBLE_EQ(typed(" cm"), 0.25);
}

TEST_F(NumberBoxTest, SaysWhatItTakesWhereALetterIsNone) {
  EXPECT_DOUBLE_EQ(typed("0.1 km"), 0.1) << "k is left out";
  EXPECT_TRUE(QToolTip::text().contains("mm, cm or m")) << QToolTip::text().toStdString();
  QToolTip::hideText();
  setUnit({});
  EXPECT_DOUBLE_EQ(typed("0.2cm"), 0.2) << "nobody knows how much that is here";
  EXPECT_FALSE(box_.taken().contains("cm"));
}

TEST_F(NumberBoxTest, HasRoomForItsDigits) {
  box_.setMostDigits(5);
  box_.setRange(0, 1000);
  EXPECT_DOUBLE_EQ(typed("0.25"), 0.25);
  EXPECT_EQ(box_.text(), QString("0.2500\u202fm"));
  EXPECT_DOUBLE_EQ(typed("100"), 100);
  EXPECT_EQ(box_.text(), QString("100.00\u202fm"));
  EXPECT_DOUBLE_EQ(typed("100.1234"), 100.1234);
  EXPECT_EQ(box_.text(), QString("100.1234\u202fm")) << "no digit of the value is lost";
}

TEST_F(NumberBoxTest, KnowsNoLengthsInAnAngle) {
  box_.setRange(0, 90);
  box_.setSuffix("°");
  EXPECT_DOUBLE_EQ(typed("45"), 45);
  EXPECT_DOUBLE_EQ(typed("30cm"), 30);
  EXPECT_FALSE(box_.taken().contains("cm"));
}

} // namespace
} // namespace espalier
