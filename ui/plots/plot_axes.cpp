#include "ui/plots/plot_axes.h"

#include "ui/document/number_scale.h"

#include <algorithm>

namespace espalier {

PlotColors plotColors(bool isDark) {
  if (isDark)
    return {.text = {0xc8, 0xce, 0xcb},
            .grid = {0x4a, 0x50, 0x55},
            .first = {0xf4, 0xf4, 0xf0},
            .second = {0xe6, 0x9f, 0x00},
            .third = {0x56, 0xb4, 0xe9},
            .chosen = {0x5c, 0xc4, 0x8d},
            .ground = {0x23, 0x26, 0x2a}};
  return {.text = {0x3a, 0x40, 0x3d},
          .grid = {0xc8, 0xce, 0xcb},
          .first = {0x16, 0x18, 0x1a},
          .second = {0xd5, 0x5e, 0x00},
          .third = {0x00, 0x72, 0xb2},
          .chosen = {0x2f, 0x8f, 0x5b},
          .ground = {0xf6, 0xf7, 0xf5}};
}

PlotPainting::PlotPainting(QPainter& painter) : painter_(painter) {
  painter_.save();
  painter_.setRenderHint(QPainter::Antialiasing);
  QFont font = painter_.font();
  font.setPixelSize(11);
  painter_.setFont(font);
}

double stepOfNumbers(double from, double to, double width, const QFontMetricsF& font) {
  constexpr double apart = 8; // pixels
  const auto widest = [&](double step) {
    double pixels = 0;
    for (const double number : multiplesOf(step, from, to))
      pixels = std::max(pixels, font.horizontalAdvance(numberAtStep(number, step)));
    return pixels;
  };
  double step = roundStep((to - from) / 3);
  while (step < to - from && widest(step) + apart > width * step / (to - from))
    step = roundStep(2.5 * step); // the next one
  return step;
}

void paintNumbersBelow(QPainter& painter, const QRectF& inner, double from, double to,
                       const PlotColors& colors) {
  const double step = stepOfNumbers(from, to, inner.width(), QFontMetricsF(painter.font()));
  for (const double number : multiplesOf(step, from, to)) {
    const double x = inner.left() + inner.width() * (number - from) / (to - from);
    painter.setPen(QPen(colors.grid, 1));
    painter.drawLine(QPointF(x, inner.bottom()), QPointF(x, inner.bottom() + 4));
    painter.setPen(colors.text);
    painter.drawText(QRectF(x - 40, inner.bottom() + 4, 80, 16), Qt::AlignCenter,
                     numberAtStep(number, step));
  }
}

} // namespace espalier
