#pragma once

#include "app/window/frame/panel_dock.h"
#include "app/window/frame/window_part.h"

namespace espalier {

class Editing;
class PlantDocument;

/// The history dock: a click on a step goes there.
class HistoryFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    Editing& editing;
    PanelDock::Parts window;
  };
  explicit HistoryFlow(const Parts& parts);

private:
  void goTo(int position);

  Parts parts_;
};

} // namespace espalier
