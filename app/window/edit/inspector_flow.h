#pragma once

#include "app/window/frame/panel_dock.h"
#include "app/window/frame/window_part.h"

namespace espalier {

class InspectorPanel;
class PlantDocument;
class PlantView;

/// The inspector dock: what is typed and chosen there about nodes.
class InspectorFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    PlantView& view;
    InspectorPanel& panel;
    PanelDock::Parts window;
  };
  explicit InspectorFlow(const Parts& parts);
};

} // namespace espalier
