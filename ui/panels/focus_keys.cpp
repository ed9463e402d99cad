#include "ui/panels/focus_keys.h"

#include <QAbstractItemView>
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

/// Keeps the keys with which one chooses in a list from being shortcuts while it is open.
class OpenList : public QObject {
public:
  explicit OpenList(QComboBox& choices) : QObject(&choices) { // owned by it
    choices.view()->installEventFilter(this);
  }

private:
  bool eventFilter(QObject* watched, QEvent* event) override {
    constexpr auto ofActions = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;
    if (event->type() == QEvent::ShortcutOverride &&
        !(static_cast<QKeyEvent*>(event)->modifiers() & ofActions))
      event->accept();
    return QObject::eventFilter(watched, event);
  }
};

bool isEnter(const QKeyEvent& press) {
  return (press.key() == Qt::Key_Return || press.key() == Qt::Key_Enter) &&
         !(press.modifiers() & ~Qt::KeypadModifier);
}

bool isEscape(const QKeyEvent& press) {
  return press.key() == Qt::Key_Escape && !press.modifiers();
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
  new OpenList(choices);
}

void onEscape(QWidget& widget, std::function<void()> act) {
  new FocusKey(widget, isEscape, std::move(act));
}

void onCopy(QWidget& widget, std::function<void()> act) {
  new FocusKey(widget, isCopy, std::move(act));
}

} // namespace espalier
