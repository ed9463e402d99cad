#include "ui/view/value_field.h"

#include <QKeyEvent>
#include <QLocale>

#include <algorithm>
#include <cmath>
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

std::optional<double> numberIn(QString text) {
  text.removeIf([](QChar letter) { return letter.isSpace(); });
  text.replace(',', '.').replace(QChar(0x2212), '-'); // as it is written
  bool isNumber = false;
  const double number = QLocale::c().toDouble(text, &isNumber);
  return isNumber && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

} // namespace espalier
