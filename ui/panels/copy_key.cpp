#include "ui/panels/copy_key.h"

#include <QKeyEvent>

#include <utility>

namespace espalier {
namespace {

class CopyKey : public QObject {
public:
  CopyKey(QWidget& widget, std::function<void()> act) : QObject(&widget), act_(std::move(act)) {
    widget.installEventFilter(this);
  }

private:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const bool isOverride = event->type() == QEvent::ShortcutOverride;
    if (isOverride || event->type() == QEvent::KeyPress) {
      if (static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)) {
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

void onCopy(QWidget& widget, std::function<void()> act) {
  new CopyKey(widget, std::move(act)); // owned by the widget
}

} // namespace espalier
