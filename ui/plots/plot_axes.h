#pragma once

#include <QColor>
#include <QFontMetricsF>
#include <QPainter>
#include <QRectF>

namespace espalier {

/// What plots are painted with.
struct PlotColors {
  QColor text;  // of numbers and names
  QColor grid;  // of axes and lines behind
  QColor first; // of lines, distinct to the color-blind, and by their dashes
  QColor second;
  QColor third;
  QColor chosen; // what the user has marked
  QColor ground; // behind texts over lines
};
/// For a screen of either theme, and for paper: as light.
[[nodiscard]] PlotColors plotColors(bool isDark);

/// A painter's font and smoothness as plots have it, until the end of the scope.
class PlotPainting {
public:
  explicit PlotPainting(QPainter& painter);
  PlotPainting(const PlotPainting&) = delete;
  PlotPainting& operator=(const PlotPainting&) = delete;
  ~PlotPainting() { painter_.restore(); }

private:
  QPainter& painter_;
};

/// The finest round step whose numbers stand apart in `width` pixels; some three steps at most.
/// pre: to > from
[[nodiscard]] double stepOfNumbers(double from, double to, double width, const QFontMetricsF& font);

/// Round numbers with their ticks below a plot whose left edge is `from`; pre: to > from
void paintNumbersBelow(QPainter& painter, const QRectF& inner, double from, double to,
                       const PlotColors& colors);

} // namespace espalier
