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

/// Keeps a row that nobody chose from being current once the keyboard is there.
class NoRowUnasked : public QObject {
public:
  explicit NoRowUnasked(QAbstractItemView& list) : QObject(&list), list_(list) {
    list.installEventFilter(this); // which owns it
  }

private:
  bool eventFilter(QObject* watched, QEvent* event) override {
    // A list makes its first row current as it gets the keyboard, unless it was set to none.
    if (event->type() == QEvent::FocusIn && !list_.currentIndex().isValid()) {
      const auto mode = list_.selectionMode();
      list_.setSelectionMode(QAbstractItemView::NoSelection); // what is selected stays so
      list_.setCurrentIndex({});
      list_.setSelectionMode(mode);
    }
    return QObject::eventFilter(watched, event);
  }

  QAbstractItemView& list_;
};

/// Keeps keys of a list from being shortcuts.
class ListKeys : public QObject {
public:
  ListKeys(QAbstractItemView& list, IsMeant isMeant) : QObject(&list), isMeant_(isMeant) {
    list.installEventFilter(this); // which owns it
  }

private:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() == QEvent::ShortcutOverride &&
        isMeant_(*static_cast<const QKeyEvent*>(event)))
      event->accept();
    return QObject::eventFilter(watched, event);
  }

  IsMeant isMeant_;
};

/// One with which one chooses in a list that is open.
bool isOfChoices(const QKeyEvent& press) {
  constexpr auto ofActions = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;
  return !(press.modifiers() & ofActions);
}

bool isOfRows(const QKeyEvent& press) {
  const int key = press.key();
  const bool isMeant =
      key == Qt::Key_Home || key == Qt::Key_End || key == Qt::Key_PageUp || key == Qt::Key_PageDown;
  return isMeant && !(press.modifiers() & ~Qt::KeypadModifier);
}

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
  new ListKeys(*choices.view(), isOfChoices);
}

void goesThroughRows(QAbstractItemView& list) {
  new ListKeys(list, isOfRows);
  new NoRowUnasked(list);
}

void onEscape(QWidget& widget, std::function<void()> act) {
  new FocusKey(widget, isEscape, std::move(act));
}

void onCopy(QWidget& widget, std::function<void()> act) {
  new FocusKey(widget, isCopy, std::move(act));
}

} // namespace espalier
