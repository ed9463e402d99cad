#pragma once

#include "core/skeleton/skeleton.h"
#include "ui/document/depth.h"

#include <Eigen/Core>
#include <QPointF>
#include <QPolygonF>
#include <QString>

#include <optional>
#include <vector>

namespace espalier {

/// What an edit would make, shown before it is made. Places in the frame of the file [L].
struct Preview {
  std::vector<std::vector<Eigen::Vector3d>> lines; // each from place to place
  std::vector<Eigen::Vector3d> nodes;
  QString label; // written at the end of the last line, else at the last node
  /// What it is made of. An arrow at the rim of the view leads to one that the view does not show.
  std::vector<Eigen::Vector3d> subjects = {};

  [[nodiscard]] bool isEmpty() const { return lines.empty() && nodes.empty() && subjects.empty(); }
  bool operator==(const Preview&) const = default;
};

/// What a tool may ask of the 3D view, and draw over it.
///
/// Areas are polygons in logical pixels from the top left of the view, as ToolInput::screen; one
/// that crosses itself takes all that it winds around. What the view does not show, because it or
/// its layer is hidden, is in no area.
class Canvas {
public:
  Canvas() = default;
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  virtual ~Canvas() = default;

  /// The nodes in an area, in order of their ids. O(nodes), and for Depth::front O(points there).
  [[nodiscard]] virtual std::vector<NodeId> nodesInside(const QPolygonF& area,
                                                        Depth depth) const = 0;
  /// The points of the scan in an area: columns of its cloud, in order. O(points there).
  [[nodiscard]] virtual std::vector<Eigen::Index> pointsInside(const QPolygonF& area,
                                                               Depth depth) const = 0;
  /// Where a place of the plant is drawn [L], in logical pixels; none if behind the eye.
  [[nodiscard]] virtual std::optional<QPointF> project(const Eigen::Vector3d& place) const = 0;

  /// Draws what the pointer has drawn, in logical pixels: a closed polygon (its last point is its
  /// first) as an area, another as a line. Empty: takes it away.
  virtual void showBand(const QPolygonF& band) = 0;
  /// Draws a preview over everything. Empty: takes it away.
  virtual void showPreview(const Preview& preview) = 0;
};

} // namespace espalier
