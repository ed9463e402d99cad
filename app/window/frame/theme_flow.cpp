#include "app/window/frame/theme_flow.h"

#include "app/window/frame/action_set.h"

#include <QAction>
#include <QActionGroup>
#include <QEvent>
#include <QSettings>
#include <QWidget>

#include <utility>

namespace espalier {

ThemeFlow::ThemeFlow(Parts parts) : parts_(std::move(parts)) {
  parts_.actions.beginSection(tr("Theme"));
  auto* group = new QActionGroup(this);
  const auto add = [&](Theme theme, const QString& text, const QString& icon) {
    group->addAction(parts_.actions.add({.id = "theme_" + nameOf(theme),
                                         .text = text,
                                         .help = tr("Changes the colors of the window"),
                                         .icon = icon,
                                         .isCheckable = true,
                                         .menu = "view/theme"},
                                        [this, theme] {
                                          parts_.settings.setValue("theme", nameOf(theme));
                                          use(theme);
                                        }));
  };
  add(Theme::system, tr("As the System"), {});
  add(Theme::light, tr("Light"), "light");
  add(Theme::dark, tr("Dark"), "dark");
  parts_.window.installEventFilter(this);
}

void ThemeFlow::start() {
  use(chosen());
}

bool ThemeFlow::eventFilter(QObject* watched, QEvent* event) {
  // Of the system: a palette that this program sets makes no such event.
  if (event->type() == QEvent::ThemeChange && chosen() == Theme::system) use(Theme::system);
  return QObject::eventFilter(watched, event);
}

void ThemeFlow::use(Theme theme) {
  parts_.actions["theme_" + nameOf(theme)]->setChecked(true);
  const bool isDark = theme == Theme::dark || (theme == Theme::system && parts_.isSystemDark());
  applyTheme(isDark);
  emit changed(isDark);
}

Theme ThemeFlow::chosen() const {
  return themeNamed(parts_.settings.value("theme").toString());
}

} // namespace espalier
