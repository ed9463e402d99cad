#pragma once

#include "core/evaluate/match/tolerance_curve.h"
#include "ui/plots/plot_axes.h"

#include <QPainter>
#include <QRectF>
#include <QString>

#include <optional>
#include <vector>

namespace espalier {

/// Precision, recall and F over the tolerance. Painted the same on a screen, in SVG and in PDF.
struct TolerancePlot {
  std::vector<ToleranceScore> curve; // by ascending distance; nothing is painted of less than two
  std::optional<ToleranceScore> chosen; // marked, with its numbers
  QString unit;                         // of lengths; empty: not known

  void paint(QPainter& painter, const QRectF& box, const PlotColors& colors) const;

  /// What the curve says of a tolerance between its ends; pre: it has two scores at least
  [[nodiscard]] ToleranceScore scoreAt(double tolerance) const;

  /// The tolerance at a place of the box, within what the curve goes over; none without a curve.
  [[nodiscard]] std::optional<double> toleranceAt(const QPointF& place, const QRectF& box) const;
};

} // namespace espalier
