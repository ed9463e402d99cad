#pragma once

#include <QPointF>
#include <QTouchEvent>

#include <optional>

namespace espalier {

class Navigator;
class PointerInput;

/// Fingers on a view: one turns the camera, two pan it and zoom by their distance. What fingers do
/// goes to no tool, but for a tap, which is a click.
class TouchInput {
public:
  /// Both must outlive it.
  TouchInput(Navigator& navigator, PointerInput& pointer)
      : navigator_(navigator), pointer_(pointer) {}

  struct Tap {
    QPointF at;
    Qt::MouseButton button; // right, if the finger rested
    bool isDouble;
  };
  /// Returns the tap that has come to its end.
  [[nodiscard]] std::optional<Tap> touch(const QTouchEvent& event);
  void cancel();

private:
  void begin(const QList<QPointF>& fingers);
  void move(const QList<QPointF>& fingers);

  Navigator& navigator_;
  PointerInput& pointer_;
  qsizetype fingers_ = 0;  // that move the camera now
  bool isTap_ = false;     // of one finger, which has not moved
  QPointF pressed_;        // where
  quint64 pressedAt_ = 0;  // [ms]
  double distance_ = 0;    // of two fingers [logical pixels]
  std::optional<Tap> tap_; // the last one
  quint64 tappedAt_ = 0;   // [ms]
};

} // namespace espalier
