#pragma once

#include "ui/view/camera.h"
#include "ui/view/scene.h"

#include <QPainter>
#include <QSizeF>
#include <QString>

namespace espalier {

/// What is written over the plant: color bar, scale bar, axes, and the pivot while turning.
struct Overlay {
  QString unit; // of lengths; empty: not known
  bool pivotShown = false;

  /// @param size of the view in logical pixels
  void paint(QPainter& painter, const Scene& scene, const Camera& camera, const QSizeF& size) const;
};

/// The largest of 1, 2 or 5 times a power of ten that is not above `length`; pre: length > 0
[[nodiscard]] double roundLength(double length);

} // namespace espalier
