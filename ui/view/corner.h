#pragma once

#include "ui/view/scene.h"

#include <QPointF>
#include <QRectF>
#include <QSizeF>

#include <vector>

namespace espalier {

/// Of a view, for what lies over the plant.
enum class Corner { topRight, topLeft, bottomRight, bottomLeft };

/// The box of a size in a corner, beside the axes and above the scale bar [logical pixels].
/// @param margin from the edges of the view
[[nodiscard]] QRectF boxIn(Corner corner, const QSizeF& box, const QSizeF& view, double margin);

/// Where some thousand places are in a view [logical pixels]; some may be beside it.
struct OnScreen {
  std::vector<QPointF> plant;    // all over it; none where something is in focus: it fills the view
  std::vector<QPointF> selected; // along nodes and edges, and points
};
/// In a view of this size. O(nodes), and O(points) if some are hidden or selected.
[[nodiscard]] OnScreen plantOnScreen(const Scene& scene, const ScreenMap& screen);

/// Something that lies over the plant in a corner.
struct InCorner {
  QSizeF box;    // [logical pixels], as all here
  double margin; // as boxIn
  Corner now;
};

/// The corner where the least of the plant is behind it, of which what is selected weighs most;
/// where it is now, unless another is clearly better or its own is taken. O(places).
/// @param taken not all corners
[[nodiscard]] Corner freestCorner(const InCorner& it, const OnScreen& plant, const QSizeF& view,
                                  const std::vector<Corner>& taken);

} // namespace espalier
