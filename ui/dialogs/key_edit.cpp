#include "ui/dialogs/key_edit.h"

#include <QKeyEvent>

#include <algorithm>
#include <array>

namespace espalier {
namespace {

/// Whether the key only changes what others mean.
bool isModifier(int key) {
  static constexpr std::array modifiers = {
      Qt::Key_Shift,   Qt::Key_Control,    Qt::Key_Alt,       Qt::Key_AltGr,
      Qt::Key_Meta,    Qt::Key_Super_L,    Qt::Key_Super_R,   Qt::Key_CapsLock,
      Qt::Key_NumLock, Qt::Key_ScrollLock, Qt::Key_Multi_key, Qt::Key_Mode_switch};
  return std::find(modifiers.begin(), modifiers.end(), key) != modifiers.end();
}

/// What one sees on the key: Shift+/ is ? on many keyboards, and is named ? alone.
QKeySequence keysOf(const QKeyEvent& event) {
  Qt::KeyboardModifiers modifiers =
      event.modifiers() & ~(Qt::KeypadModifier | Qt::GroupSwitchModifier);
  const QString text = event.text();
  const bool isSign =
      text.size() == 1 && text[0].isPrint() && !text[0].isSpace() && !text[0].isLetter();
  if (isSign) modifiers &= ~Qt::ShiftModifier;
  return QKeyCombination(modifiers, Qt::Key(event.key()));
}

} // namespace

KeyEdit::KeyEdit(QWidget* parent) : QLineEdit(parent) {
  setReadOnly(true);
  setContextMenuPolicy(Qt::NoContextMenu);
  setPlaceholderText(tr("Press the new keys"));
}

void KeyEdit::setKeys(const QKeySequence& keys) {
  if (keys == keys_) return;
  keys_ = keys;
  setText(keys.toString(QKeySequence::NativeText));
  emit keysChanged(keys_);
}

bool KeyEdit::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept(); // no command hears these keys
    return true;
  }
  return QLineEdit::event(event);
}

void KeyEdit::keyPressEvent(QKeyEvent* event) {
  event->accept();
  if (isModifier(event->key()) || event->key() == Qt::Key_unknown || event->key() == 0) return;
  setKeys(keysOf(*event));
}

} // namespace espalier
