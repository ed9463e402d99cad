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

} // namespace espalier
