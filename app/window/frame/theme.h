#pragma once

#include <QColor>
#include <QPalette>
#include <QString>

namespace espalier {

enum class Theme { system, light, dark };

/// "system", "light", "dark": as settings keep it. Any other name is system.
[[nodiscard]] QString nameOf(Theme theme);
[[nodiscard]] Theme themeNamed(const QString& name);

/// The colors of the window around the plant.
struct ThemeColors {
  QColor panel; // docks, bars
  QColor field; // what is typed into, lists
  QColor button;
  QColor hover; // things under the pointer
  QColor border;
  QColor text;
  QColor quiet;   // secondary text
  QColor accent;  // focus, running step
  QColor primary; // primary buttons
  QColor onPrimary;
  QColor error; // ground of an error message
  QColor onError;
};

[[nodiscard]] ThemeColors themeColors(bool dark);

/// Is the system dark now? Takes the palette of the program away for as long as it asks.
[[nodiscard]] bool isSystemDark();

/// Gives the whole program a dark or a light look.
void applyTheme(bool isDark);

} // namespace espalier
