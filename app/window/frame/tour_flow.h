#pragma once

#include "app/window/frame/window_part.h"

#include <functional>

class QSettings;
class QWidget;

namespace espalier {

class ActionSet;
class PlantDocument;
class TourHint;

/// A tour of three hints, one after the other: find the skeleton, look at what is in doubt, sign.
/// It begins by itself with the first scan that is opened, once, and else by a command.
class TourFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    ActionSet& actions; // of all other parts
    QSettings& settings;
    QWidget& window;
  };
  explicit TourFlow(const Parts& parts);

  void setPlantShown(bool isShown) override; // its panels are there

private:
  void begin();
  void goTo(int step); // 1 to 3; beyond: the tour ends
  void leave();
  [[nodiscard]] QString keysOf(const char* action) const;

  Parts parts_;
  TourHint* hint_;
  int step_ = 0;           // 0: no tour
  bool isAwaited_ = false; // it begins with the scan that is being opened
};

} // namespace espalier
