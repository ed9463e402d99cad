#include "ui/view/legend.h"

#include "ui/view/overlay_text.h"

#include <QFontMetricsF>
#include <QLinearGradient>
#include <QLocale>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

// [logical pixels]
constexpr double margin = 16;
constexpr double titleHeight = 24;
constexpr double barWidth = 10;
constexpr double rowHeight = 20;

QString titleOf(const Legend& legend) {
  return legend.unit.isEmpty() ? legend.title
                               : legend.title + QStringLiteral(" [%1]").arg(legend.unit);
}

void paintBar(QPainter& painter, const Legend& legend, const QRectF& bar, const Palette& colors,
              bool dark) {
  QLinearGradient gradient(bar.bottomLeft(), bar.topLeft());
  for (int i = 0; i <= 16; ++i)
    gradient.setColorAt(i / 16.0, toQt(colorOf(legend.map, i / 16.0, dark)));
  painter.setPen(Qt::NoPen);
  painter.setBrush(gradient);
  painter.drawRoundedRect(bar, 3, 3);
  const double range = legend.to - legend.from;
  const double step = roundLength(range / 3);
  for (double value = std::ceil(legend.from / step) * step; value <= legend.to; value += step) {
    const double y = bar.bottom() - bar.height() * (value - legend.from) / range;
    painter.setPen(toQt(colors.text));
    painter.drawLine(QPointF(bar.left() - 4, y), QPointF(bar.left() - 1, y));
    drawText(painter, QRectF(bar.left() - 108, y - 10, 100, 20), Qt::AlignRight | Qt::AlignVCenter,
             scaleNumber(value, step), colors);
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

/// Returns its width.
double paintLegend(QPainter& painter, const Legend& legend, double right, double height,
                   bool dark) {
  const Palette colors = palette(dark);
  const QFontMetricsF font(painter.font(), painter.device());
  double width = std::max(86 + barWidth, font.horizontalAdvance(titleOf(legend)) + 4);
  for (const Legend::Category& category : legend.categories)
    width = std::max(width, font.horizontalAdvance(category.name) + barWidth + 12);
  const double rows = rowHeight * static_cast<double>(legend.categories.size());
  const double body = legend.categories.empty() ? height : rows;
  const double left = right - width;
  paintVeil(painter, QRectF(left - 8, margin - 8, width + 16, body + titleHeight + 20),
            colors.backgroundTop);
  drawText(painter, QRectF(left, margin - 4, width, 20), Qt::AlignRight | Qt::AlignVCenter,
           titleOf(legend), colors);
  if (legend.categories.empty())
    paintBar(painter, legend, QRectF(right - barWidth, margin + titleHeight, barWidth, height),
             colors, dark);
  else
    paintCategories(painter, legend, QRectF(left, margin + titleHeight, width, rows), colors);
  return width;
}

} // namespace

void paintLegends(QPainter& painter, const std::vector<Legend>& legends, const QSizeF& size,
                  bool dark) {
  const double height = std::min(180.0, 0.4 * size.height());
  double right = size.width() - margin;
  for (const Legend& legend : legends)
    right -= paintLegend(painter, legend, right, height, dark) + 24;
}

QString scaleNumber(double value, double step) {
  const int digits = std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 9);
  QLocale locale = QLocale::c();
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  if (std::abs(value) < 1e-9 * step) value = 0; // no "-0"
  QString text = locale.toString(value, 'f', digits);
  // Thin spaces between thousands, as everywhere in the window.
  const qsizetype end = text.contains('.') ? text.indexOf('.') : text.size();
  for (qsizetype i = end - 3; i > (text.startsWith('-') ? 1 : 0); i -= 3)
    text.insert(i, QChar(0x202f));
  return text;
}

double roundLength(double length) {
  const double power = std::pow(10, std::floor(std::log10(length) + 1e-9));
  const double rest = length / power * (1 + 1e-9);
  return (rest >= 5 ? 5 : rest >= 2 ? 2 : 1) * power;
}

} // namespace espalier
