#include "ui/view/value_field.h"

#include <QKeyEvent>

#include <utility>

namespace espalier {

ValueField::ValueField(const QString& text, QWidget* view) : QLineEdit(text, view) {
  setObjectName("color_range_field");
  setAlignment(Qt::AlignRight);
  setContextMenuPolicy(Qt::NoContextMenu);
}

void ValueField::open() {
  isOpen_ = true;
  show();
  setFocus(Qt::OtherFocusReason);
  selectAll();
}

bool ValueField::event(QEvent* event) {
  const bool isPressed = event->type() == QEvent::KeyPress;
  if (!isPressed && event->type() != QEvent::ShortcutOverride) return QLineEdit::event(event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  const bool isEnter = key == Qt::Key_Return || key == Qt::Key_Enter;
  const bool isTab = key == Qt::Key_Tab || key == Qt::Key_Backtab;
  if (!isEnter && !isTab && key != Qt::Key_Escape) return QLineEdit::event(event);
  event->accept(); // before any shortcut of the window hears of it
  if (isPressed) close(key != Qt::Key_Escape, isTab);
  return true;
}

void ValueField::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  close(true, false);
}

void ValueField::close(bool takes, bool goesOn) {
  if (!std::exchange(isOpen_, false)) return;
  if (hasFocus()) parentWidget()->setFocus();
  hide();
  deleteLater();
  if (takes) emit typed(text(), goesOn);
}

} // namespace espalier
