#pragma once

#include "app/window/frame/window_part.h"

#include <QPointer>

#include <functional>

class QSettings;
class QWidget;

namespace espalier {

class ActionSet;
class KeyBindings;
class ManualWindow;

/// Where a command is found: by its name, in the manual, by its key, which can be another.
///
/// The manual opens at the chapter of what one is in: the panel that has the keyboard, else the
/// tool that is chosen, or the dialog that is open.
class HelpFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    ActionSet& actions; // of all other parts
    QSettings& settings;
    QWidget& window;
    std::function<QString()> placeOfTool; // in the manual, of the tool that is chosen
  };
  explicit HelpFlow(const Parts& parts);
  ~HelpFlow() override;

  /// Where the manual would open now.
  [[nodiscard]] QString manualPlace() const;

signals:
  void keysAsked(); // before they are shown

protected:
  bool eventFilter(QObject* watched, QEvent* event) override; // F1 in dialogs, which have no menu

private:
  void addActions();
  void showPalette();
  void showManual();

  Parts parts_;
  KeyBindings* keys_;
  QPointer<ManualWindow> manual_; // null: not open
};

} // namespace espalier
