#pragma once

#include "app/window/frame/theme.h"
#include "app/window/frame/window_part.h"

#include <functional>

class QSettings;
class QWidget;

namespace espalier {

class ActionSet;

/// The choice of a theme. "As the System" follows the system while the program runs.
class ThemeFlow : public WindowPart {
  Q_OBJECT

public:
  /// What it works with; all must outlive it.
  struct Parts {
    ActionSet& actions;
    QSettings& settings;
    QWidget& window; // is notified when the system changes
    std::function<bool()> isSystemDark = espalier::isSystemDark;
  };
  explicit ThemeFlow(Parts parts);

  /// Gives the program the theme that the settings remember.
  void start();

signals:
  void changed(bool isDark);

protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

private:
  void use(Theme theme);
  [[nodiscard]] Theme chosen() const;

  Parts parts_;
};

} // namespace espalier
