#pragma once

#include "app/window/frame/panel_dock.h"
#include "app/window/frame/window_part.h"

namespace espalier {

class Editing;
class NodeTablePanel;
class PlantDocument;

/// The table of nodes and Copy: what is typed into the table is edited, what is copied is text.
class NodeTableFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    Editing& editing;
    PanelDock::Parts window;
  };
  explicit NodeTableFlow(const Parts& parts);

private:
  void connectTable();
  void guarded(const std::function<void()>& act);
  void copy();
  void copyTable();

  Parts parts_;
  NodeTablePanel* panel_;
};

} // namespace espalier
