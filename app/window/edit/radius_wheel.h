#pragma once

#include "ui/document/gesture.h"
#include "ui/document/plant_document.h"

#include <QObject>

#include <functional>
#include <vector>

namespace espalier {

class ActionSet;

/// Ctrl+wheel over the plant: thicker or thinner, 5 % a notch. Turns over the same nodes are one
/// undo step, until something else is edited. Without nodes to act on the wheel zooms as ever.
class RadiusWheel : public QObject {
  Q_OBJECT

public:
  using Nodes = std::function<std::vector<NodeId>()>;

  /// @param nodes  that the wheel is meant for; none while nothing may be edited
  RadiusWheel(PlantDocument& document, ActionSet& actions, Nodes nodes, QObject* parent);

  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void turn(const std::vector<NodeId>& nodes, double notches);
  [[nodiscard]] bool goesOn(const std::vector<NodeId>& nodes) const;

  PlantDocument& document_;
  ActionSet& actions_;
  Nodes nodes_;
  std::vector<NodeId> turned_; // by gesture_
  Gesture gesture_;
};

} // namespace espalier
