#pragma once

#include "ui/document/canvas.h"
#include "ui/view/camera.h"

#include <QPainter>
#include <QPolygonF>

namespace espalier {

/// A box, lasso or stroke, as Canvas::showBand.
void paintBand(QPainter& painter, const QPolygonF& band, bool dark);

/// What an edit would make, as Canvas::showPreview: translucent, so that what is there stays to be
/// seen. Lines are drawn where both their ends are before the eye.
void paintPreview(QPainter& painter, const Preview& preview, const ScreenMap& screen, bool dark);

/// The place that was chosen for the root.
void paintRootMark(QPainter& painter, const Eigen::Vector3d& place, const ScreenMap& screen,
                   bool dark);

} // namespace espalier
