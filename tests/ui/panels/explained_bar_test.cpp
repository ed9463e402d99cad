#include "ui/panels/explained_bar.h"
#include "ui/panels/option_slider.h"

#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <gtest/gtest.h>

namespace espalier {
namespace {

/// Of a plant in mm whose points are usually explained within 20.
struct ExplainedBarTest : testing::Test {
  ExplainedBar bar;
  OptionSlider& slider = *bar.findChild<OptionSlider*>("explained_slider");
  QDoubleSpinBox& number = *bar.findChild<QDoubleSpinBox*>("explained_number");
  QSignalSpy changes{&bar, &ExplainedBar::changed};

  void SetUp() override {
    bar.setLimits(20, 1, "mm");
    bar.show();
  }
};

TEST_F(ExplainedBarTest, BeginsAtTheUsualDistance) {
  EXPECT_EQ(bar.distance(), 20);
  EXPECT_EQ(number.value(), 20);
  EXPECT_EQ(number.suffix(), QChar(0x202f) + QStringLiteral("mm"));
  EXPECT_EQ(changes.count(), 0);
}

TEST_F(ExplainedBarTest, GoesSixtyFourTimesAsFarAndAsNear) {
  slider.setFocus();
  QTest::keyClick(&slider, Qt::Key_End);
  EXPECT_NEAR(bar.distance(), 20 * 64, 1e-9);
  QTest::keyClick(&slider, Qt::Key_Home);
  EXPECT_NEAR(bar.distance(), 20.0 / 64, 1e-9);
  EXPECT_EQ(changes.count(), 2);
}

TEST_F(ExplainedBarTest, TakesATypedDistance) {
  number.setValue(1000);
  EXPECT_EQ(bar.distance(), 1000);
  EXPECT_LT(slider.place(), 1);
}

TEST_F(ExplainedBarTest, ADoubleClickGoesBackToTheDefault) {
  number.setValue(7);
  QTest::mouseDClick(&slider, Qt::LeftButton);
  EXPECT_EQ(bar.distance(), 20);
}

TEST_F(ExplainedBarTest, SetsASensitivityThatStaysWithAnotherScan) {
  QSignalSpy chosen(&bar, &ExplainedBar::sensitivityChosen);
  number.setValue(5);
  ASSERT_EQ(chosen.count(), 1);
  EXPECT_EQ(chosen[0][0].toDouble(), 4);
  bar.setLimits(0.04, 4, "m");
  EXPECT_NEAR(bar.distance(), 0.01, 1e-12);
  EXPECT_NEAR(number.value(), 0.01, 1e-12);
  EXPECT_EQ(chosen.count(), 1) << "shown, not chosen";
}

TEST_F(ExplainedBarTest, ReportsWhetherToHide) {
  EXPECT_FALSE(bar.isHiding());
  QTest::mouseClick(bar.findChild<QToolButton*>("explained_hide"), Qt::LeftButton);
  EXPECT_TRUE(bar.isHiding());
  EXPECT_EQ(changes.count(), 1);
}

} // namespace
} // namespace espalier
