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

/// A dock of the window with the action that shows it, brings it to the front, or hides it if it is
/// there. Whether it is shown is remembered. Those of one side share one place, as tabs, unless one
/// asks for its own.
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
    QString menu = QStringLiteral("panels"); // the place of the action
    QString manual;                          // where the panel is described: "compare.md"
  };
  struct Place {
    Qt::DockWidgetArea side = Qt::BottomDockWidgetArea;
    int size = 220;        // [pixels] across that side; of a window of 800 the plant keeps most
    bool isShown = false;  // until one has chosen
    bool isTab = true;     // else it has a place of its own, as wide or high as what is beside it
    bool isOfPlant = true; // else it is there without one, too
  };
  PanelDock(const Parts& parts, const Name& name, QWidget* panel, QObject* parent)
      : PanelDock(parts, name, Place(), panel, parent) {}
  PanelDock(const Parts& parts, const Name& name, const Place& place, QWidget* panel,
            QObject* parent);

  void setPlantShown(bool isShown); // without a plant the panel is absent
  void bringToFront();              // shown, if it was not
  void growBy(int pixels);          // in height; of the window at most half
  void resetLayout();
  [[nodiscard]] bool isShown() const;
  [[nodiscard]] bool isInFront() const; // shown, and not behind another tab

signals:
  void shown(bool isShown); // or hidden: not whether another tab lies before it

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  [[nodiscard]] bool isBehind() const; // another tab
  void place();
  void takeSize();
  [[nodiscard]] bool isAlone() const; // of its place
  void refresh();

  Parts parts_;
  Place place_;
  QString action_; // its id
  QDockWidget* dock_;
  bool isPlantShown_ = false;
  bool wasShown_ = false; // as shown() reported last
};

/// At the right. The side docks together take under a third of the width of a small screen.
constexpr PanelDock::Place besideThePlant{.side = Qt::RightDockWidgetArea, .size = 196};

} // namespace espalier
