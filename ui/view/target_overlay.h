#pragma once

#include "ui/view/camera.h"
#include "ui/view/shown_scan.h"

#include <QPainter>

namespace espalier {

/// Paints the targets that were picked in two scans over them: a ring in the color of its scan at
/// each place, a line from one to the other, and the number of the pair.
void paintTargets(QPainter& painter, const ShownScan& scan, const ScreenMap& screen, bool dark);

} // namespace espalier
