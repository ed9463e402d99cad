#pragma once

#include "app/window/panel_dock.h"

#include <QObject>

namespace espalier {

class Editing;
class PlantDocument;

/// The history dock: a click on a step goes there.
class HistoryFlow : public QObject {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    Editing& editing;
    PanelDock::Parts window;
  };
  explicit HistoryFlow(const Parts& parts);

  [[nodiscard]] PanelDock& dock() { return *dock_; }

signals:
  void noted(const QString& text);

private:
  void goTo(int position);

  Parts parts_;
  PanelDock* dock_;
};

} // namespace espalier
