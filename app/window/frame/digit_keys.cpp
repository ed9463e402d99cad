#include "app/window/frame/digit_keys.h"

#include "app/window/frame/action_set.h"

#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QWidget>

#include <optional>

namespace espalier {
namespace {

/// The digit whose key is pressed alone and types something else. X and Wayland number the keys of
/// the row from 10, which is that of 1, to 19, that of 0.
std::optional<int> digitOf(const QKeyEvent& press) {
  constexpr quint32 keyOfOne = 10;
  constexpr quint32 keyOfZero = 19;
  const quint32 key = press.nativeScanCode();
  const bool isDigit = press.key() >= Qt::Key_0 && press.key() <= Qt::Key_9;
  if (isDigit || press.modifiers() != Qt::NoModifier || key < keyOfOne || key > keyOfZero)
    return std::nullopt;
  return static_cast<int>((key - keyOfOne + 1) % 10);
}

} // namespace

DigitKeys::DigitKeys(const ActionSet& actions, QObject* parent)
    : QObject(parent), actions_(actions) {
  QCoreApplication::instance()->installEventFilter(this);
}

/// A press comes by only where no shortcut is what was typed.
bool DigitKeys::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress || QApplication::activeModalWidget() != nullptr)
    return false;
  const QWidget* widget = QApplication::focusWidget();
  const bool isField = widget != nullptr && widget->testAttribute(Qt::WA_InputMethodEnabled);
  if (widget != watched || isField) return false; // what a field leaves comes by here, too
  const auto digit = digitOf(*static_cast<const QKeyEvent*>(event));
  if (!digit) return false;
  const QKeySequence keys(Qt::Key_0 + *digit);
  for (QAction* action : actions_.all()) {
    if (!action->isEnabled() || !action->shortcuts().contains(keys)) continue;
    action->trigger();
    return true;
  }
  return false;
}

} // namespace espalier
