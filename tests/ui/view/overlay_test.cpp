#include "ui/view/legend.h"

#include <QImage>
#include <QPainter>
#include <gtest/gtest.h>

namespace espalier {
namespace {

TEST(RoundLength, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(roundLength(1), 1);
  EXPECT_DOUBLE_EQ(roundLength(1.99), 1);
  EXPECT_DOUBLE_EQ(roundLength(2), 2);
  EXPECT_DOUBLE_EQ(roundLength(4.9), 2);
  EXPECT_DOUBLE_EQ(roundLength(5), 5);
  EXPECT_DOUBLE_EQ(roundLength(99), 50);
  EXPECT_DOUBLE_EQ(roundLength(1000), 1000);
  EXPECT_DOUBLE_EQ(roundLength(0.003), 0.002);
}

/// What is left of a red ground at a corner of the box of a color bar, clear of its text.
QColor groundUnderBar(const QSize& size) {
  Legend legend;
  legend.title = "Height";
  legend.to = 1;
  QImage image(size, QImage::Format_RGB32);
  image.fill(Qt::red);
  QPainter painter(&image);
  const QRectF veil =
      legendBoxes({legend}, size, QFontMetricsF(painter.font(), painter.device())).front().veil;
  paintLegends(painter, {legend}, size, false);
  return image.pixelColor(veil.bottomLeft().toPoint() + QPoint(8, -3));
}

TEST(Legends, VeilThePlantOnlyWhereThereIsRoomBesideIt) {
  EXPECT_NE(groundUnderBar({800, 600}), QColor(Qt::red));
  EXPECT_EQ(groundUnderBar({400, 600}), QColor(Qt::red));
}

} // namespace
} // namespace espalier
