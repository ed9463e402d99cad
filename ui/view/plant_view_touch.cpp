#include "ui/view/plant_view_parts.h"

#include <QMouseEvent>

namespace espalier {

/// A hand that rests beside the pen, or the mouse that drags, moves nothing.
bool PlantView::Parts::takeTouch(QTouchEvent& event) {
  event.accept();
  if (event.type() == QEvent::TouchCancel || owner.isInGesture()) {
    touch.cancel();
    return true;
  }
  if (event.type() == QEvent::TouchBegin) {
    if (owner.childAt(event.points().front().position().toPoint()) != nullptr) {
      event.ignore(); // a color bar or the like has the mouse that Qt makes of it
      return false;
    }
    owner.setFocus(Qt::MouseFocusReason);
  }
  if (const auto tap = touch.touch(event)) click(*tap);
  redrawThis(); // the pivot is shown while one finger turns
  return true;
}

void PlantView::Parts::click(const TouchInput::Tap& tap) {
  const auto mouse = [&](QEvent::Type type, Qt::MouseButton button, Qt::MouseButtons buttons) {
    return QMouseEvent(type, tap.at, owner.mapToGlobal(tap.at), button, buttons, Qt::NoModifier);
  };
  QMouseEvent hover = mouse(QEvent::MouseMove, Qt::NoButton, Qt::NoButton);
  owner.mouseMoveEvent(&hover);
  QMouseEvent press = mouse(tap.isDouble ? QEvent::MouseButtonDblClick : QEvent::MouseButtonPress,
                            tap.button, tap.button);
  if (tap.isDouble)
    owner.mouseDoubleClickEvent(&press);
  else
    owner.mousePressEvent(&press);
  QMouseEvent release = mouse(QEvent::MouseButtonRelease, tap.button, Qt::NoButton);
  owner.mouseReleaseEvent(&release);
}

} // namespace espalier
