#pragma once

#include "ui/document/plant_document.h"
#include "ui/document/tool_input.h"

#include <QKeySequence>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

namespace espalier {

[[nodiscard]] QString nodeName(NodeId id);                       // "node 1842"
[[nodiscard]] QString nodeNames(const std::vector<NodeId>& ids); // the same, or "3 nodes"

/// What a key or a menu acts on.
struct NodeTarget {
  std::vector<NodeId> nodes;                                // contained in the document
  std::optional<EdgePick> edge;                             // under the pointer
  Eigen::Vector3d viewDirection = Eigen::Vector3d::UnitY(); // into the screen
};

/// The nodes meant by a key: those chosen, unless the pointer is on another node.
[[nodiscard]] NodeTarget targetOf(PlantDocument& document, const Pick& under,
                                  const Eigen::Vector3d& viewDirection);

/// An edit that a key or a menu makes at once.
struct NodeEdit {
  QString id;   // never translated: settings and tests know it by this
  QString text; // in menus
  QString help; // what it does, one line
  QString icon; // name in resources/icons, or empty
  QKeySequence shortcut;
  /// Makes the edit, as one undo step.
  /// @throws Error if it is refused
  std::function<void(PlantDocument&, const NodeTarget&)> apply;
  QString menu = {};         // it stands in a menu of this name within the menu
  bool isOfSelected = false; // wherever the pointer is
  bool takesEdge = false;    // under the pointer; others need a node
};

/// All of them, in the order of the menu; the keys are PlantScan3D's where it has them.
[[nodiscard]] std::vector<NodeEdit> nodeEdits();

/// How far from a node the points of its section may lie [L]. pre: there is a scan
[[nodiscard]] double sectionReach(const PlantDocument& document, NodeId id);

/// Applies `change` to each node as one undo step named `text` (%1: the nodes), and skips those
/// that an earlier one removed.
void editEach(PlantDocument& document, const NodeTarget& target, const QString& text,
              const std::function<void(SkeletonEditor&, NodeId)>& change);

/// Multiplies the radii of nodes; calls of one gesture become one undo step.
/// @throws Error if a node has no radius yet
void scaleRadii(PlantDocument& document, const std::vector<NodeId>& nodes, double factor,
                Gesture gesture);

/// Sets the radius of nodes by hand. pre: radius >= 0 [L]
void setRadius(PlantDocument& document, const std::vector<NodeId>& nodes, double radius);

} // namespace espalier
