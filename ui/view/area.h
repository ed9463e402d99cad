#pragma once

#include "ui/document/canvas.h"
#include "ui/view/camera.h"
#include "ui/view/scene.h"

#include <QPolygonF>

#include <vector>

namespace espalier {

/// As Canvas::nodesInside and Canvas::pointsInside, in a scene seen on a screen.
[[nodiscard]] std::vector<NodeId> nodesInside(const Scene& scene, const ScreenMap& screen,
                                              const QPolygonF& area, Depth depth);
[[nodiscard]] std::vector<Eigen::Index> pointsInside(const Scene& scene, const ScreenMap& screen,
                                                     const QPolygonF& area, Depth depth);

/// All points that are shown, on the screen or not: not hidden, and in the clip. O(points).
[[nodiscard]] std::vector<Eigen::Index> pointsShown(const Scene& scene, const Camera& camera);

} // namespace espalier
