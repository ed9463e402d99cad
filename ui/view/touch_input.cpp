#include "ui/view/touch_input.h"

#include "ui/view/navigator.h"
#include "ui/view/pointer_input.h"

#include <QGuiApplication>
#include <QLineF>
#include <QStyleHints>

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

constexpr double tapReach = 10;       // [logical pixels]: a finger that moves less has tapped
constexpr double doubleTapReach = 30; // likewise, between two taps
constexpr double leastDistance = 20;  // likewise, of two fingers

QPointF middleOf(const QList<QPointF>& fingers) {
  return (fingers.front() + fingers.back()) / 2;
}

double distanceOf(const QList<QPointF>& fingers) {
  return std::max(leastDistance, QLineF(fingers.front(), fingers.back()).length());
}

} // namespace

void TouchInput::begin(const QList<QPointF>& fingers) {
  navigator_.end();
  fingers_ = fingers.size();
  if (fingers_ == 1) {
    navigator_.begin(Navigator::Gesture::turn, fingers.front(), pointer_.zoomAnchor(fingers[0]));
  } else if (fingers_ == 2) {
    const QPointF middle = middleOf(fingers);
    distance_ = distanceOf(fingers);
    navigator_.begin(Navigator::Gesture::pan, middle, pointer_.zoomAnchor(middle));
  }
}

void TouchInput::move(const QList<QPointF>& fingers) {
  if (fingers_ == 1) {
    isTap_ = isTap_ && QLineF(pressed_, fingers.front()).length() <= tapReach;
    if (!isTap_) navigator_.drag(fingers.front());
  } else if (fingers_ == 2) {
    navigator_.drag(middleOf(fingers));
    const double distance = distanceOf(fingers);
    navigator_.pinch(distance / std::exchange(distance_, distance));
  }
}

std::optional<TouchInput::Tap> TouchInput::touch(const QTouchEvent& event) {
  QList<QPointF> fingers;
  for (const QEventPoint& point : event.points())
    if (point.state() != QEventPoint::Released) fingers.append(point.position());
  if (event.type() == QEvent::TouchBegin && fingers.size() == 1) {
    isTap_ = true;
    pressed_ = fingers.front();
    pressedAt_ = event.timestamp();
  }
  if (fingers.size() > 1) isTap_ = false;
  if (fingers.size() != fingers_)
    begin(fingers);
  else
    move(fingers);
  if (event.type() != QEvent::TouchEnd || !std::exchange(isTap_, false)) return std::nullopt;
  const QStyleHints& hints = *QGuiApplication::styleHints();
  const quint64 now = event.timestamp();
  const bool hasRested =
      now - pressedAt_ >= static_cast<quint64>(hints.mousePressAndHoldInterval());
  const bool isSoon = now - tappedAt_ <= static_cast<quint64>(hints.mouseDoubleClickInterval());
  const bool isSecond = tap_ && !tap_->isDouble && tap_->button == Qt::LeftButton && isSoon &&
                        QLineF(tap_->at, pressed_).length() <= doubleTapReach;
  tap_ = Tap{pressed_, hasRested ? Qt::RightButton : Qt::LeftButton, isSecond && !hasRested};
  tappedAt_ = now;
  return tap_;
}

void TouchInput::cancel() {
  isTap_ = false;
  fingers_ = 0;
  navigator_.end();
}

} // namespace espalier
