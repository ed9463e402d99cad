#include "app/window/frame/menu_title.h"

#include <QLabel>
#include <QMenu>
#include <QWidgetAction>

namespace espalier {

QAction* addTitle(QMenu& menu, const QString& text) {
  auto* label = new QLabel(text);
  label->setProperty("role", "section");
  label->setContentsMargins(10, 6, 10, 4);
  auto* title = new QWidgetAction(&menu);
  title->setDefaultWidget(label);
  title->setText(text); // for screen readers
  title->setEnabled(false);
  menu.addAction(title);
  return title;
}

} // namespace espalier
