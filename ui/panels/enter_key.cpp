#include "ui/panels/enter_key.h"

#include <QComboBox>
#include <QKeyEvent>

#include <utility>

namespace espalier {
namespace {

class EnterKey : public QObject {
public:
  EnterKey(QWidget& widget, std::function<void()> act) : QObject(&widget), act_(std::move(act)) {
    widget.installEventFilter(this);
  }

private:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const bool isOverride = event->type() == QEvent::ShortcutOverride;
    if (isOverride || event->type() == QEvent::KeyPress) {
      const auto* press = static_cast<const QKeyEvent*>(event);
      const bool isEnter = press->key() == Qt::Key_Return || press->key() == Qt::Key_Enter;
      if (isEnter && !(press->modifiers() & ~Qt::KeypadModifier)) {
        if (isOverride)
          event->accept(); // so that it comes as a press, before any action
        else
          act_();
        return true;
      }
    }
    return QObject::eventFilter(watched, event);
  }

  std::function<void()> act_;
};

} // namespace

void onEnter(QWidget& widget, std::function<void()> act) {
  new EnterKey(widget, std::move(act)); // owned by the widget
}

void opensOnEnter(QComboBox& choices) {
  onEnter(choices, [&choices] { choices.showPopup(); });
}

} // namespace espalier
