#pragma once

#include "ui/view/camera.h"
#include "ui/view/palette.h"

#include <QColor>
#include <QPainter>
#include <QPointF>
#include <QRectF>
#include <QString>

#include <optional>

namespace espalier {

[[nodiscard]] inline QColor toQt(const Color& color, int alpha = 255) {
  return {color[0], color[1], color[2], alpha};
}

/// Text with a rim of the background, readable on points.
void drawText(QPainter& painter, const QRectF& box, int alignment, const QString& text,
              const Palette& colors);

/// Text on a veil beside a place, kept in what is painted on.
void paintLabel(QPainter& painter, const QPointF& at, const QString& label, const Palette& colors);

/// A veil under what is to be read over the plant.
void paintVeil(QPainter& painter, const QRectF& box, const Color& background);

/// Where a place is seen [logical pixels]; none behind the eye.
[[nodiscard]] std::optional<QPointF> pixelOf(const ScreenMap& screen, const Eigen::Vector3d& place);

} // namespace espalier
