#pragma once

#include "ui/view/color_map.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QRectF>
#include <QSizeF>

#include <vector>

namespace espalier {

/// Where a legend is painted [logical pixels].
struct LegendBox {
  QRectF veil;  // all of it
  QRectF scale; // histogram and colors, the greatest value on top; empty if it has categories

  /// The height on the screen of a value of the legend, and the value at a height.
  [[nodiscard]] double placeOf(const Legend& legend, double value) const;
  [[nodiscard]] double valueAt(const Legend& legend, double place) const;
};
[[nodiscard]] std::vector<LegendBox> legendBoxes(const std::vector<Legend>& legends,
                                                 const QSizeF& size, const QFontMetricsF& font);

/// Color bars, or lists of categories, side by side from the right at the top of a view.
/// @param size of the view [logical pixels]
void paintLegends(QPainter& painter, const std::vector<Legend>& legends, const QSizeF& size,
                  bool dark);

/// The ends of a range, as written at a color bar.
[[nodiscard]] QString rangeNumber(double value, const ValueRange& range);

/// A number with as many digits as a step between such numbers calls for.
[[nodiscard]] QString scaleNumber(double value, double step);

/// The largest of 1, 2 or 5 times a power of ten that is not above `length`; pre: length > 0
[[nodiscard]] double roundLength(double length);

} // namespace espalier
