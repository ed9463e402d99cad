#pragma once

#include "core/surface/convex_hull.h"
#include "ui/view/camera.h"

#include <QPainter>
#include <QString>

namespace espalier {

/// A convex body about a part of the plant, and what is written at its top.
struct ShownHull {
  ConvexHull hull; // frame of the file [L]
  QString label;
};

/// Paints a body as glass, over the plant that is in it: a tinted outline, and the edges of its
/// near side. Nothing of one that reaches behind the eye.
void paintHull(QPainter& painter, const ShownHull& shown, const ScreenMap& screen, bool dark);

} // namespace espalier
