#pragma once

#include "ui/document/canvas.h"

namespace espalier::test {

/// A view that shows nothing: notes what a tool draws over it, and finds in an area what it is set
/// to find. Pixels are those of Mouse.
class QuietCanvas : public Canvas {
public:
  std::vector<NodeId> nodes;        // found in any area
  std::vector<Eigen::Index> points; // likewise
  QPolygonF band;                   // shown now
  Preview preview;                  // likewise
  mutable QPolygonF asked;          // the last area
  mutable Depth depth = Depth::front;

  std::vector<NodeId> nodesInside(const QPolygonF& area, Depth how) const override {
    asked = area;
    depth = how;
    return nodes;
  }
  std::vector<Eigen::Index> pointsInside(const QPolygonF& area, Depth how) const override {
    asked = area;
    depth = how;
    return points;
  }
  std::optional<QPointF> project(const Eigen::Vector3d& place) const override {
    return QPointF(100 * place.x(), -100 * place.z());
  }
  void showBand(const QPolygonF& shown) override { band = shown; }
  void showPreview(const Preview& shown) override { preview = shown; }
};

} // namespace espalier::test
