#pragma once

#include "app/window/frame/window_part.h"
#include "ui/tools/move_node_tool.h"

class QSettings;

namespace espalier {

class ActionSet;
class Editing;
class PlantDocument;

/// What nodes that are dragged snap to: a choice in a menu, remembered in the settings.
class SnapFlow : public WindowPart {
  Q_OBJECT

public:
  /// All must outlive it.
  SnapFlow(PlantDocument& document, ActionSet& actions, const Editing& editing,
           QSettings& settings);

private:
  void choose(Snap snap);
  void showChoice();

  PlantDocument& document_;
  ActionSet& actions_;
  QSettings& settings_;
  MoveNodeTool* tool_;
};

} // namespace espalier
