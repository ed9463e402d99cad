#include "ui/document/number_scale.h"
#include "ui/plots/plot_view.h"

#include <QBuffer>
#include <QImage>
#include <QPdfWriter>
#include <QSignalSpy>
#include <QTest>
#include <gtest/gtest.h>

namespace espalier {
namespace {

const QRectF box(0, 0, 400, 200);

/// Precision is 1, recall 0.5 at all tolerances from 0 to 50.
TolerancePlot plot() {
  TolerancePlot made{.curve = {}, .chosen = ToleranceScore{25, 1, 0.5}, .unit = "mm"};
  for (int i = 0; i <= 10; ++i)
    made.curve.push_back({5.0 * i, 1, 0.5});
  return made;
}

QImage painted(const TolerancePlot& plot, bool isDark) {
  QImage image(400, 200, QImage::Format_RGB32);
  image.fill(isDark ? Qt::black : Qt::white);
  QPainter painter(&image);
  plot.paint(painter, box, plotColors(isDark));
  return image;
}

/// The rows of the picture that have this color at half of the width.
std::vector<int> rowsOf(const QImage& image, const QColor& color, int column) {
  std::vector<int> rows;
  for (int y = 0; y < image.height(); ++y)
    if (image.pixelColor(column, y) == color) rows.push_back(y);
  return rows;
}

TEST(TolerancePlot, DrawsSharesAtTheirHeightOnBothThemes) {
  for (const bool isDark : {false, true}) {
    const QImage image = painted(plot(), isDark);
    const PlotColors colors = plotColors(isDark);
    int top = 0;
    int bottom = 0;
    for (int x = 40; x < 330; ++x) {
      for (const int y : rowsOf(image, colors.second, x))
        top = std::max(top, y);
      for (const int y : rowsOf(image, colors.third, x))
        bottom = std::max(bottom, y);
    }
    EXPECT_NEAR(top, 8, 6) << "precision 1 is at the top";
    EXPECT_NEAR(bottom, 8 + (200 - 8 - 36) / 2, 6) << "recall 0.5 amid the axes";
  }
}

TEST(TolerancePlot, ReturnsTheToleranceUnderThePointerWithinItsRange) {
  const TolerancePlot made = plot();
  double before = -1;
  for (const double x : {-50.0, 100.0, 200.0, 300.0}) {
    const double tolerance = *made.toleranceAt({x, 100}, box);
    EXPECT_GT(tolerance, before);
    before = tolerance;
  }
  EXPECT_EQ(*made.toleranceAt({-50, 100}, box), 0);
  EXPECT_EQ(*made.toleranceAt({900, 100}, box), 50);
  EXPECT_FALSE(TolerancePlot().toleranceAt({100, 100}, box));
}

TEST(TolerancePlot, ReturnsScoresBetweenThoseOfTheCurve) {
  const TolerancePlot made{.curve = {{0, 0, 0.2}, {10, 1, 0.4}}, .chosen = {}, .unit = {}};
  EXPECT_DOUBLE_EQ(made.scoreAt(2.5).precision, 0.25);
  EXPECT_DOUBLE_EQ(made.scoreAt(2.5).recall, 0.25);
  EXPECT_DOUBLE_EQ(made.scoreAt(99).precision, 1);
}

TEST(TolerancePlot, IsPaintedAlikeIntoAPdf) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&buffer);
    QPainter painter(&writer);
    plot().paint(painter, box, plotColors(false));
  }
  EXPECT_TRUE(buffer.data().startsWith("%PDF"));
  EXPECT_GT(buffer.size(), 1000);
}

TEST(TolerancePlot, PaintsNothingWithoutACurve) {
  QImage white(400, 200, QImage::Format_RGB32);
  white.fill(Qt::white);
  EXPECT_EQ(painted({}, false), white);
}

TEST(PlotView, ChoosesAToleranceByDraggingAndByArrowKeys) {
  PlotView view;
  view.resize(400, 200);
  view.show(plot());
  view.QWidget::show();
  const QSignalSpy chosen(&view, &PlotView::toleranceChosen);
  QTest::mousePress(&view, Qt::LeftButton, {}, QPoint(186, 100)); // amid the axes
  ASSERT_EQ(chosen.size(), 1);
  EXPECT_NEAR(chosen[0][0].toDouble(), 25, 1);
  QTest::mouseMove(&view, QPoint(276, 100));
  QTest::mouseRelease(&view, Qt::LeftButton, {}, QPoint(276, 100));
  const double dragged = chosen.last()[0].toDouble();
  EXPECT_NEAR(dragged, 40, 1);
  QTest::keyClick(&view, Qt::Key_Right);
  EXPECT_NEAR(chosen.last()[0].toDouble(), dragged + 5, 1e-9) << "a step of the curve";
  QTest::keyClick(&view, Qt::Key_Left);
  EXPECT_NEAR(chosen.last()[0].toDouble(), dragged, 1e-9);
  QTest::mousePress(&view, Qt::LeftButton, {}, QPoint(0, 100));
  EXPECT_GT(chosen.last()[0].toDouble(), 0) << "a tolerance is never none";
}

TEST(PlotAxes, WritesNoNumberOverAnother) {
  const QFontMetricsF font{QFont()};
  const auto numbers = [&](double width) { // and how much of the width they take
    const double step = stepOfNumbers(0, 0.05, width, font);
    std::pair<std::size_t, double> found{0, 0};
    for (const double number : multiplesOf(step, 0, 0.05)) {
      ++found.first;
      found.second += font.horizontalAdvance(numberAtStep(number, step));
    }
    return found;
  };
  const double one = font.horizontalAdvance("0.05");
  EXPECT_EQ(numbers(20 * one).first, 6U) << "as many as a third of the range calls for";
  for (const double width : {6 * one, 4 * one, 3 * one})
    EXPECT_LT(numbers(width).second, width + one) << "the outer ones reach beyond by halves";
  EXPECT_LT(numbers(4 * one).first, 6U);
}

} // namespace
} // namespace espalier
