#pragma once

#include "app/window/frame/window_part.h"

#include <QPointer>

#include <functional>
#include <vector>

class QDockWidget;
class QMainWindow;
class QWidget;

namespace espalier {

class ActionSet;

/// Leads the keyboard between the plant and the panels: a key gives it to the panel that was used
/// last, and on to the next; a panel that goes gives it back to the plant.
class PanelFocus : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    ActionSet& actions;
    QMainWindow& window; // with all its docks
    std::function<void()> toPlant;
    std::function<bool()> hasPreview; // that waits for an answer
  };
  explicit PanelFocus(const Parts& parts);

  /// Of the panel that has the keyboard, what the keys for panels do.
  [[nodiscard]] QString furtherHint() const override;

private:
  void follow(QDockWidget& dock);
  void noteUsed(QDockWidget& dock);
  void goOn();
  [[nodiscard]] std::vector<QDockWidget*> docksInFront() const; // from left to right

  Parts parts_;
  std::vector<QDockWidget*> used_; // the last one last
  QPointer<QDockWidget> in_;       // the one that has the keyboard
};

} // namespace espalier
