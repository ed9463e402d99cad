#include "ui/panels/focus_keys.h"

#include <QComboBox>
#include <QKeyEvent>

#include <utility>

namespace espalier {
namespace {

using IsMeant = bool (*)(const QKeyEvent& press);

class FocusKey : public QObject {
public:
  FocusKey(QWidget& widget, IsMeant isMeant, std::function<void()> act)
      : QObject(&widget), isMeant_(isMeant), act_(std::move(act)) { // owned by the widget
    widget.installEventFilter(this);
  }

private:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const bool isOverride = event->type() == QEvent::ShortcutOverride;
    const bool isKey = isOverride || event->type() == QEvent::KeyPress;
    if (!isKey || !isMeant_(*static_cast<const QKeyEvent*>(event)))
      return QObject::eventFilter(watched, event);
    if (isOverride)
      event->accept(); // so that it comes as a press, before any action
    else
      act_();
    return true;
  }

  IsMeant isMeant_;
  std::function<void()> act_;
};

bool isEnter(const QKeyEvent& press) {
  return (press.key() == Qt::Key_Return || press.key() == Qt::Key_Enter) &&
         !(press.modifiers() & ~Qt::KeypadModifier);
}

bool isCopy(const QKeyEvent& press) {
  return press.matches(QKeySequence::Copy);
}

} // namespace

void onEnter(QWidget& widget, std::function<void()> act) {
  new FocusKey(widget, isEnter, std::move(act));
}

void opensOnEnter(QComboBox& choices) {
  onEnter(choices, [&choices] { choices.showPopup(); });
}

void onCopy(QWidget& widget, std::function<void()> act) {
  new FocusKey(widget, isCopy, std::move(act));
}

} // namespace espalier
