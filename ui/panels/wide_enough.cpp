#include "ui/panels/wide_enough.h"

#include <QEvent>
#include <QScrollArea>
#include <QScrollBar>

namespace espalier {
namespace {

class WideEnough : public QObject {
public:
  explicit WideEnough(QScrollArea& area) : QObject(&area), area_(area) {}

  bool eventFilter(QObject* page, QEvent* event) override {
    if (event->type() == QEvent::LayoutRequest)
      area_.setMinimumWidth(area_.widget()->minimumSizeHint().width() +
                            area_.verticalScrollBar()->sizeHint().width());
    return QObject::eventFilter(page, event);
  }

private:
  QScrollArea& area_;
};

} // namespace

void keepWideEnough(QScrollArea& area) {
  area.widget()->installEventFilter(new WideEnough(area));
}

} // namespace espalier
