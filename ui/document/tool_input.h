#pragma once

#include "core/skeleton/skeleton.h"
#include "ui/document/depth.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <QPointF>
#include <Qt>

#include <optional>

namespace espalier {

/// A place on the edge between a node and its parent.
struct EdgePick {
  NodeId child;
  double fraction;          // 0 at the parent, 1 at the child
  Eigen::Vector3d position; // [L], on the edge
};

/// What is under the pointer. At most one of node and edge is set: a node wins over its edges.
struct Pick {
  std::optional<NodeId> node;
  std::optional<EdgePick> edge;
  std::optional<Eigen::Vector3d> point; // nearest visible scan point, where it is drawn [L]
  bool isOfOther = false;               // the point: contracted by another state than the plant
  /// Likewise, behind strays that float before it: of a pole, a wire, a plant.
  std::optional<Eigen::Vector3d> pointOfThing = {};
  /// Likewise, of another scan that is laid over the plant: its column.
  std::optional<Eigen::Index> movedPoint = {};
};

/// One act of the mouse in the 3D view, in terms of the plant: all that an editing tool is given.
struct ToolInput {
  enum class Phase { hover, press, drag, release, doubleClick, cancel };

  Phase phase = Phase::hover;
  Eigen::ParametrizedLine<double, 3> ray; // from the eye through the pointer [L], unit direction
  Eigen::Vector3d viewDirection = Eigen::Vector3d::UnitY(); // into the screen, unit length
  Pick pick;                                                // while dragging: what is there now
  Qt::MouseButton button = Qt::NoButton;                    // the one that started the gesture
  Qt::KeyboardModifiers modifiers = Qt::NoModifier;
  Depth depth = Depth::front; // what an area drawn now takes
  QPointF screen;             // logical pixels from the top left of the view
};

} // namespace espalier
