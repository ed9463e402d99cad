#include "ui/panels/blend_bar.h"

#include <QPushButton>
#include <QSignalSpy>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(BlendBar, BeginsWhereContractionPutsThePoints) {
  const BlendBar bar;
  EXPECT_EQ(bar.blend(), 1);
  EXPECT_FALSE(bar.showsDisplacements());
}

TEST(BlendBar, ReportsWhereTheHandPutsThem) {
  BlendBar bar;
  QSignalSpy changed(&bar, &BlendBar::changed);
  auto* slider = bar.findChild<QSlider*>("blend_slider");
  QTest::keyClick(slider, Qt::Key_Home);
  EXPECT_EQ(bar.blend(), 0);
  QTest::keyClick(slider, Qt::Key_PageUp);
  EXPECT_NEAR(bar.blend(), 0.05, 1e-9);
  QTest::mouseDClick(slider, Qt::LeftButton, {}, slider->rect().center());
  EXPECT_EQ(bar.blend(), 1) << "a double click gives the usual place back";
  QTest::mouseClick(bar.findChild<QToolButton*>("blend_ways"), Qt::LeftButton);
  EXPECT_TRUE(bar.showsDisplacements());
  EXPECT_EQ(changed.count(), 4);
}

TEST(BlendBar, AsksToBeClosed) {
  BlendBar bar;
  QSignalSpy closed(&bar, &BlendBar::closeRequested);
  QTest::mouseClick(bar.findChild<QPushButton*>("blend_close"), Qt::LeftButton);
  EXPECT_EQ(closed.count(), 1);
}

} // namespace
} // namespace espalier
