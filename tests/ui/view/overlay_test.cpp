#include "ui/view/legend.h"
#include "ui/view/overlay_of_tools.h"
#include "ui/view/palette.h"

#include <QImage>
#include <QPainter>
#include <gtest/gtest.h>

#include <cstdlib>

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

/// How far a color on a ground of points in the accent stands out from it, in [0, 3 * 255].
int contrastWith(const Color& accent, const QColor& color) {
  return std::abs(color.red() - accent[0]) + std::abs(color.green() - accent[1]) +
         std::abs(color.blue() - accent[2]);
}

TEST(PaintedByTools, StandsOutFromPointsOfItsColor) {
  for (const bool isDark : {false, true}) {
    const Color accent = palette(isDark).contracted;
    QImage image(200, 100, QImage::Format_RGB32);
    image.fill(qRgb(accent[0], accent[1], accent[2]));
    QPainter painter(&image);
    paintBand(painter, QPolygonF({{10, 20}, {190, 20}}), isDark);
    Camera camera;
    camera.frame(Eigen::AlignedBox3d(Eigen::Vector3d(-1, 0, -1), Eigen::Vector3d(1, 0, 1)), 2);
    const ScreenMap screen(camera, {200, 100});
    const Preview preview{.lines = {{{-0.5, 0, 0}, {0.5, 0, 0}}}, .nodes = {}, .label = {}};
    paintPreview(painter, preview, screen, isDark);
    EXPECT_GT(contrastWith(accent, image.pixelColor(100, 18)), 100) << "beside the stroke";
    const auto middle = screen.project({0, 0, 0});
    ASSERT_TRUE(middle);
    const QPoint beside(int(middle->pixel.x()), int(middle->pixel.y()) - 3);
    EXPECT_GT(contrastWith(accent, image.pixelColor(beside)), 100) << "beside the preview";
  }
}

} // namespace
} // namespace espalier
