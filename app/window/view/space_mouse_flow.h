#pragma once

#include "app/window/frame/window_part.h"

namespace espalier {

class ActionSet;
class Editing;
class SpaceMouse;

/// A 3D mouse moves the plant in the view that the pointer was in last; its first two buttons frame
/// all of the plant, and what is selected. The driver is looked for whenever one comes back to the
/// program, so that a mouse may be plugged in at any time.
class SpaceMouseFlow : public WindowPart {
  Q_OBJECT

public:
  /// All must outlive it.
  struct Parts {
    Editing& editing;
    ActionSet& actions;
    QWidget& window; // steers only while it, or a panel of it, is active: the driver serves all
  };
  explicit SpaceMouseFlow(const Parts& parts);

private:
  Parts parts_;
  SpaceMouse* mouse_;
};

} // namespace espalier
