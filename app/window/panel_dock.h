#pragma once

#include <QKeySequence>
#include <QObject>
#include <QString>

class QDockWidget;
class QMainWindow;
class QSettings;
class QWidget;

namespace espalier {

class ActionSet;

/// A dock at the bottom of the window with the action that shows it, brings it to the front, or
/// hides it if it is there. It begins hidden; whether it is shown is remembered. All of them share
/// one place, as tabs.
class PanelDock : public QObject {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    ActionSet& actions;
    QSettings& settings;
    QMainWindow& window;
  };
  struct Name {
    QString id;    // "history": of the dock; that of the action is "show_history"
    QString title; // of the dock
    QString text;  // of the action
    QString help;
    QKeySequence keys;
  };
  PanelDock(const Parts& parts, const Name& name, QWidget* panel, QObject* parent);

  void setPlantShown(bool isShown); // without a plant the panel is absent
  void bringToFront();              // shown, if it was not
  void growBy(int pixels);          // in height; of the window at most half
  void resetLayout();
  [[nodiscard]] bool isShown() const;
  [[nodiscard]] bool isInFront() const; // shown, and not behind another tab

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  [[nodiscard]] bool isBehind() const; // another tab
  void place();
  void refresh();

  Parts parts_;
  QString action_; // its id
  QDockWidget* dock_;
  bool isPlantShown_ = false;
};

} // namespace espalier
