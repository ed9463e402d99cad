#pragma once

#include "ui/document/binned_values.h"
#include "ui/plots/plot_axes.h"

#include <QString>

#include <optional>

namespace espalier {

/// How often each value is found, with a marked range. Painted the same on a screen, in SVG and in
/// PDF. What lies beyond the bins is one bar on its side, a little apart from them.
struct HistogramPlot {
  /// Values that are marked; both ends belong to them.
  struct Brush {
    double from = 0;
    double to = 0;
    std::size_t count = 0; // of values between
  };
  /// A number of the whole that is shown elsewhere, too.
  struct Mark {
    double value = 0;
    QString text; // "median 1.13"
  };

  BinnedValues bins;
  std::optional<BinnedValues> second; // in the same bins: an outline over the bars
  QString title;
  QString unit; // of the values; empty: they have none, or it is not known
  QString secondName;
  std::optional<Brush> brush;
  std::optional<Mark> mark; // a dashed line, with its text
  bool areComing = false;   // the values: there are none yet

  void paint(QPainter& painter, const QRectF& box, const PlotColors& colors) const;

  /// The ends of all that is shown, the bars on the sides included. pre: !bins.isEmpty()
  [[nodiscard]] double least() const;
  [[nodiscard]] double greatest() const;
  /// Where a value is painted; what lies beyond the bins is at the outer side of its bar.
  [[nodiscard]] double placeOf(double value, const QRectF& box) const;
  /// The value at a place; beside the bins, least() or greatest().
  [[nodiscard]] double valueAt(double x, const QRectF& box) const;
  /// What the bar at a place stands for, with its count; empty: there is none.
  [[nodiscard]] QString tipAt(const QPointF& place, const QRectF& box) const;
  /// The numbers of the marked range: "3.1 – 7.4 mm · 12 345 (23 %)". pre: brush
  [[nodiscard]] QString brushText() const;
  [[nodiscard]] QString emptyText() const; // in place of bars
  /// A value with as many digits as distinguish bins, without the unit.
  [[nodiscard]] QString numberOf(double value) const;
};

} // namespace espalier
