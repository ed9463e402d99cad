#pragma once

#include "ui/panels/message_banner.h"

#include <QObject>
#include <QString>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace espalier {

class PanelDock;

/// A message over the plant, with what can be done about it.
struct Notice {
  QString text;
  bool isError = false;
  std::vector<BannerAction> actions = {}; // at most two
  bool isStep = false;                    // of the history: Undo is offered, and no other action
};

/// What a project keeps beside the plant, as one text by name. `show` gets the text of a project
/// that is opened, and the empty one for a new plant; it may throw an Error.
struct Kept {
  std::string name;
  std::function<std::string()> text;
  std::function<void(const std::string&)> show;
};

/// A part of the window: a subject with its commands, its panel, and what is kept of it.
///
/// The window knows its parts by this alone. A part says once what it brings: its actions with
/// their places in the menus (ActionSet), its docks, and what a project keeps. The rest is asked
/// when it is needed. Parts are made, and joined where one needs another, in
/// main_window_parts.cpp.
class WindowPart : public QObject {
  Q_OBJECT

public:
  [[nodiscard]] const std::vector<PanelDock*>& docks() const { return docks_; }
  [[nodiscard]] const std::vector<Kept>& kept() const { return kept_; }

  /// In the middle of something that is not a job of the window: a computation of its own, a drag.
  [[nodiscard]] virtual bool isBusy() const { return false; }
  virtual void stop() {} // computes no further: the whole plant is reconstructed

  virtual void setEnabled(bool /*isEnabled*/) {}  // off while a job runs that replaces the skeleton
  virtual void setPlantShown(bool /*isShown*/) {} // its docks follow by themselves

  /// For the status line. What the mouse does now: that of the last part which has one is shown.
  [[nodiscard]] virtual QString hint() const { return {}; }
  [[nodiscard]] virtual QString furtherHint() const { return {}; } // behind that one
  [[nodiscard]] virtual QString count() const { return {}; }       // "3 hidden"

  /// Whether the window may close now; may ask the user.
  /// @throws Error if something is to be saved first and cannot be
  [[nodiscard]] virtual bool mayClose() { return true; }
  virtual void beginWork() {} // the window is there, with all parts
  virtual void endWork() {}   // it goes; all parts are still there

signals:
  void noted(const QString& message);  // in the status line
  void failed(const QString& message); // an error, in the banner
  void reported(const espalier::Notice& notice);
  void outdated(); // what the banner says
  void hintChanged();
  void countChanged();
  void keptChanged(); // the text of something kept may be another

protected:
  PanelDock* addDock(PanelDock* dock) {
    docks_.push_back(dock);
    return dock;
  }
  void keepInProject(Kept kept) { kept_.push_back(std::move(kept)); }

private:
  std::vector<PanelDock*> docks_;
  std::vector<Kept> kept_;
};

} // namespace espalier
