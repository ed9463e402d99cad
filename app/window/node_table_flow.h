#pragma once

#include "app/window/panel_dock.h"

#include <QObject>

namespace espalier {

class Editing;
class NodeTablePanel;
class PlantDocument;

/// The table of nodes and Copy: what is typed into the table is edited, what is copied is text.
class NodeTableFlow : public QObject {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    PlantDocument& document;
    Editing& editing;
    PanelDock::Parts window;
  };
  explicit NodeTableFlow(const Parts& parts);

  [[nodiscard]] PanelDock& dock() { return *dock_; }

signals:
  void noted(const QString& text);

private:
  void connectTable();
  void guarded(const std::function<void()>& act);
  void copy();
  void copyTable();

  Parts parts_;
  NodeTablePanel* panel_;
  PanelDock* dock_;
};

} // namespace espalier
