#pragma once

#include "ui/view/color_map.h"
#include "ui/view/corner.h"

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

/// Side by side from the right, in a corner of a view.
[[nodiscard]] std::vector<LegendBox> legendBoxes(const std::vector<Legend>& legends,
                                                 const QSizeF& size, const QFontMetricsF& font,
                                                 Corner corner);
/// All of them together; an empty box if there are none.
[[nodiscard]] InCorner legendsInCorner(const std::vector<Legend>& legends, const QSizeF& size,
                                       const QFontMetricsF& font, Corner now);

/// Color bars, or lists of categories, as legendBoxes().
/// @param size of the view [logical pixels]
void paintLegends(QPainter& painter, const std::vector<Legend>& legends, const QSizeF& size,
                  Corner corner, bool dark);

/// A value as it is written at the ends of the range of a color bar: to about a hundredth of the
/// range, but lengths no finer than to 1 mm where the range is over 1 cm.
[[nodiscard]] QString rangeNumber(double value, const ValueRange& range, const QString& unit);

} // namespace espalier
