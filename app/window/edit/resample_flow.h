#pragma once

#include "ui/document/plant_document.h"

#include <QObject>

#include <functional>
#include <vector>

class QWidget;

namespace espalier {

class ActionSet;

/// Asks for the length of edges, and spaces the nodes of a path by it.
class ResampleFlow : public QObject {
  Q_OBJECT

public:
  using Nodes = std::function<std::vector<NodeId>()>;

  /// @param nodes  that the command is meant for; refused by an Error if there are none
  ResampleFlow(PlantDocument& document, ActionSet& actions, Nodes nodes, QObject* parent);

private:
  void ask(const std::vector<NodeId>& nodes);

  PlantDocument& document_;
};

} // namespace espalier
