#include "app/window/frame/menu_keys.h"

#include <QApplication>
#include <QEvent>
#include <QMenu>

namespace espalier {

MenuKeys::MenuKeys(QObject* parent) : QObject(parent) {
  QCoreApplication::instance()->installEventFilter(this);
}

/// A key that is asked for by this event, and accepted, is no shortcut. (Qt sees to that of itself,
/// but not where the pointer opened a menu within the menu.)
bool MenuKeys::eventFilter(QObject* /*watched*/, QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return false;
  if (qobject_cast<QMenu*>(QApplication::activePopupWidget()) == nullptr) return false;
  event->accept();
  return true;
}

} // namespace espalier
