#pragma once

#include "ui/view/color_map.h"

#include <QPainter>
#include <QSizeF>

#include <vector>

namespace espalier {

/// Color bars, or lists of categories, side by side from the right at the top of a view.
/// @param size of the view [logical pixels]
void paintLegends(QPainter& painter, const std::vector<Legend>& legends, const QSizeF& size,
                  bool dark);

/// A number with as many digits as a step between such numbers calls for.
[[nodiscard]] QString scaleNumber(double value, double step);

/// The largest of 1, 2 or 5 times a power of ten that is not above `length`; pre: length > 0
[[nodiscard]] double roundLength(double length);

} // namespace espalier
