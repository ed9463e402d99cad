#pragma once

#include "app/window/frame/window_part.h"

class QSettings;
class QWidget;

namespace espalier {

class ActionSet;
class KeyBindings;

/// Where a command is found: by its name, in the manual, by its key, which can be another.
class HelpFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    ActionSet& actions; // of all other parts
    QSettings& settings;
    QWidget& window;
  };
  explicit HelpFlow(const Parts& parts);

private:
  void addActions();
  void showPalette();

  Parts parts_;
  KeyBindings* keys_;
};

} // namespace espalier
