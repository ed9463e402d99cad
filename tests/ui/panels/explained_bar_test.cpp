#include "ui/panels/explained_bar.h"
#include "ui/panels/option_slider.h"

#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <gtest/gtest.h>

namespace espalier {
namespace {

/// Of a scan in mm whose points are 5 apart.
struct ExplainedBarTest : testing::Test {
  ExplainedBar bar;
  OptionSlider& slider = *bar.findChild<OptionSlider*>("explained_slider");
  QDoubleSpinBox& number = *bar.findChild<QDoubleSpinBox*>("explained_number");
  QSignalSpy changes{&bar, &ExplainedBar::changed};

  void SetUp() override {
    bar.setSpacing(5, "mm");
    bar.show();
  }
};

TEST_F(ExplainedBarTest, BeginsAtFourSpacings) {
  EXPECT_EQ(bar.distance(), 20);
  EXPECT_EQ(number.value(), 20);
  EXPECT_EQ(number.suffix(), QChar(0x202f) + QStringLiteral("mm"));
  EXPECT_EQ(changes.count(), 0);
}

TEST_F(ExplainedBarTest, GoesFromNothingToSixtyFourSpacings) {
  slider.setFocus();
  QTest::keyClick(&slider, Qt::Key_End);
  EXPECT_NEAR(bar.distance(), 320, 1e-9);
  QTest::keyClick(&slider, Qt::Key_Home);
  EXPECT_EQ(bar.distance(), 0);
  EXPECT_EQ(changes.count(), 2);
}

TEST_F(ExplainedBarTest, TakesATypedDistanceBeyondTheSlider) {
  number.setValue(1000);
  EXPECT_EQ(bar.distance(), 1000);
  EXPECT_EQ(slider.place(), 1);
}

TEST_F(ExplainedBarTest, ADoubleClickGoesBackToTheDefault) {
  number.setValue(7);
  QTest::mouseDClick(&slider, Qt::LeftButton);
  EXPECT_EQ(bar.distance(), 20);
}

TEST_F(ExplainedBarTest, AChosenDistanceStaysInAnotherUnitAndIsForgottenWithThePlant) {
  number.setValue(7);
  bar.setSpacing(5, "cm");
  EXPECT_EQ(bar.distance(), 7);
  bar.forgetDistance();
  bar.setSpacing(0.01, "m");
  EXPECT_NEAR(bar.distance(), 0.04, 1e-12);
  EXPECT_NEAR(number.value(), 0.04, 1e-12);
}

TEST_F(ExplainedBarTest, ReportsWhetherToHide) {
  EXPECT_FALSE(bar.isHiding());
  QTest::mouseClick(bar.findChild<QToolButton*>("explained_hide"), Qt::LeftButton);
  EXPECT_TRUE(bar.isHiding());
  EXPECT_EQ(changes.count(), 1);
}

} // namespace
} // namespace espalier
