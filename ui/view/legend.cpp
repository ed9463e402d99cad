#include "ui/view/legend.h"

#include "ui/document/number_scale.h"
#include "ui/view/overlay_text.h"

#include <QLinearGradient>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

// [logical pixels]
constexpr double legendMargin = 16;
constexpr double veilMargin = 8;
constexpr double titleHeight = 24;
constexpr double barWidth = 10;
constexpr double scaleWidth = 46; // the bar and the histogram
constexpr double numberWidth = 64;
constexpr double rowHeight = 20;
constexpr double leastVeiled = 560; // views that are narrower have no room beside the plant

/// 0: not known.
double millimeterIn(const QString& unit) {
  if (unit == QStringLiteral("mm")) return 1;
  if (unit == QStringLiteral("cm")) return 0.1;
  return unit == QStringLiteral("m") ? 0.001 : 0;
}

QString titleOf(const Legend& legend) {
  return legend.unit.isEmpty() ? legend.title
                               : legend.title + QStringLiteral(" [%1]").arg(legend.unit);
}

/// Height of what is under the title.
double bodyHeight(const Legend& legend, const QSizeF& size) {
  if (!legend.categories.empty()) return rowHeight * static_cast<double>(legend.categories.size());
  return std::min(180.0, 0.4 * size.height());
}

double widthOf(const Legend& legend, const QFontMetricsF& font) {
  double width = std::max(numberWidth + scaleWidth, font.horizontalAdvance(titleOf(legend)) + 4);
  for (const Legend::Category& category : legend.categories)
    width = std::max(width, font.horizontalAdvance(category.name) + barWidth + 12);
  return width;
}

void paintColors(QPainter& painter, const Legend& legend, const LegendBox& box, bool dark) {
  const LegendColors colors(legend, dark);
  const QRectF strip(box.scale.right() - barWidth, box.scale.top(), barWidth, box.scale.height());
  QLinearGradient gradient(strip.bottomLeft(), strip.topLeft());
  const ValueRange axis = legend.axis();
  constexpr int steps = 128;
  for (int i = 0; i <= steps; ++i)
    gradient.setColorAt(double(i) / steps,
                        toQt(colors(axis.from + (axis.to - axis.from) * i / steps)));
  painter.setPen(Qt::NoPen);
  painter.setBrush(gradient);
  painter.drawRoundedRect(strip, 3, 3);
}

/// To the left of the colors; what lies beyond the range is fainter.
void paintHistogram(QPainter& painter, const Legend& legend, const LegendBox& box,
                    const Palette& colors) {
  const std::vector<int>& counts = legend.histogram.counts;
  const int most = counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
  if (most == 0) return;
  const ValueRange& range = legend.histogram.range;
  const double step = (range.to - range.from) / static_cast<double>(counts.size());
  const double right = box.scale.right() - barWidth - 2;
  painter.setPen(Qt::NoPen);
  painter.setRenderHint(QPainter::Antialiasing, false); // bins join without seams
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == 0) continue;
    const double from = range.from + step * static_cast<double>(i);
    const double top = box.placeOf(legend, from + step);
    const double length = std::max(1.0, (scaleWidth - barWidth - 2) * counts[i] / most);
    const bool isBeyond = from + step / 2 < legend.from || from + step / 2 > legend.to;
    painter.setBrush(toQt(colors.text, isBeyond ? 60 : 140));
    painter.drawRect(QRectF(right - length, top, length, box.placeOf(legend, from) - top));
  }
  painter.setRenderHint(QPainter::Antialiasing);
}

/// The ends of the range, and round numbers where there is room between them.
void paintNumbers(QPainter& painter, const Legend& legend, const LegendBox& box,
                  const Palette& colors) {
  const double left = box.scale.left();
  const auto write = [&](double place, const QString& text) {
    drawText(painter, QRectF(left - 108, place - 10, 102, 20), Qt::AlignRight | Qt::AlignVCenter,
             text, colors);
  };
  const ValueRange range{legend.from, legend.to};
  const double bottom = box.placeOf(legend, range.from);
  const double top = box.placeOf(legend, range.to);
  const double apart = std::max(0.0, (rowHeight - 4 - (bottom - top)) / 2);
  write(bottom + apart, rangeNumber(range.from, range, legend.unit));
  write(top - apart, rangeNumber(range.to, range, legend.unit));
  for (const double place : {bottom, top}) {
    painter.setPen(QPen(toQt(colors.text), 1));
    painter.drawLine(QPointF(left - 2, place), QPointF(box.scale.right(), place));
  }
  const double step = roundStep((range.to - range.from) / 3);
  for (const double value : multiplesOf(step, range.from, range.to)) {
    const double place = box.placeOf(legend, value);
    if (std::min(bottom - place, place - top) < rowHeight) continue;
    painter.setPen(toQt(colors.text));
    painter.drawLine(QPointF(left - 2, place), QPointF(left + 2, place));
    write(place, numberAtStep(value, step));
  }
}

void paintCategories(QPainter& painter, const Legend& legend, const QRectF& box,
                     const Palette& colors) {
  double top = box.top();
  for (const Legend::Category& category : legend.categories) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(toQt(category.color));
    painter.drawRoundedRect(QRectF(box.right() - barWidth, top + 5, barWidth, barWidth), 2, 2);
    drawText(painter, QRectF(box.left(), top, box.width() - barWidth - 8, rowHeight),
             Qt::AlignRight | Qt::AlignVCenter, category.name, colors);
    top += rowHeight;
  }
}

void paintLegend(QPainter& painter, const Legend& legend, const LegendBox& box, bool dark) {
  const Palette colors = palette(dark);
  const QRectF inner = box.veil.adjusted(8, 4, -8, -8);
  drawText(painter, QRectF(inner.left(), inner.top(), inner.width(), 20),
           Qt::AlignRight | Qt::AlignVCenter, titleOf(legend), colors);
  if (!legend.categories.empty()) {
    paintCategories(painter, legend, inner.adjusted(0, titleHeight + 4, 0, 0), colors);
    return;
  }
  paintHistogram(painter, legend, box, colors);
  paintColors(painter, legend, box, dark);
  paintNumbers(painter, legend, box, colors);
}

QSizeF sizeOf(const std::vector<LegendBox>& boxes) {
  QRectF all;
  for (const LegendBox& box : boxes)
    all |= box.veil;
  return all.size();
}

} // namespace

double LegendBox::placeOf(const Legend& legend, double value) const {
  const ValueRange axis = legend.axis();
  return scale.bottom() - scale.height() * (value - axis.from) / (axis.to - axis.from);
}

double LegendBox::valueAt(const Legend& legend, double place) const {
  const ValueRange axis = legend.axis();
  return axis.from + (axis.to - axis.from) * (scale.bottom() - place) / scale.height();
}

std::vector<LegendBox> legendBoxes(const std::vector<Legend>& legends, const QSizeF& size,
                                   const QFontMetricsF& font, Corner corner) {
  std::vector<LegendBox> boxes;
  double right = size.width() - legendMargin;
  for (const Legend& legend : legends) {
    const double width = widthOf(legend, font);
    const double height = bodyHeight(legend, size);
    LegendBox box{
        .veil = {right - width - 8, legendMargin - 8, width + 16, height + titleHeight + 20},
        .scale = {}};
    if (legend.categories.empty())
      box.scale = {right - scaleWidth, legendMargin + titleHeight, scaleWidth, height};
    boxes.push_back(box);
    right -= width + 24;
  }
  const QRectF all = boxIn(corner, sizeOf(boxes), size, veilMargin);
  const double left = all.right() - (size.width() - veilMargin); // less than 0: to the left
  const bool isAtBottom = corner == Corner::bottomRight || corner == Corner::bottomLeft;
  for (LegendBox& box : boxes) {
    const QPointF shift(left, isAtBottom ? all.bottom() - box.veil.bottom() : 0);
    box.veil.translate(shift);
    box.scale.translate(shift);
  }
  return boxes;
}

InCorner legendsInCorner(const std::vector<Legend>& legends, const QSizeF& size,
                         const QFontMetricsF& font, Corner now) {
  return {sizeOf(legendBoxes(legends, size, font, now)), veilMargin, now};
}

void paintLegends(QPainter& painter, const std::vector<Legend>& legends, const QSizeF& size,
                  Corner corner, bool dark) {
  const QFontMetricsF font(painter.font(), painter.device());
  const std::vector<LegendBox> boxes = legendBoxes(legends, size, font, corner);
  for (std::size_t i = 0; i < legends.size(); ++i) {
    if (size.width() >= leastVeiled) paintVeil(painter, boxes[i].veil, palette(dark).backgroundTop);
    paintLegend(painter, legends[i], boxes[i], dark);
  }
}

QString rangeNumber(double value, const ValueRange& range, const QString& unit) {
  const double length = range.to - range.from;
  const double finest = std::min(millimeterIn(unit), length / 10);
  return numberAtStep(value, roundStep(std::max(length / 100, finest)));
}

} // namespace espalier
