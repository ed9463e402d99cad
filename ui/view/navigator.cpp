#include "ui/view/navigator.h"

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr double turnPerPixel = 0.007; // [rad]
constexpr double zoomPerPixel = 0.006; // as a power of e
constexpr double zoomPerStep = 0.16;   // likewise, a notch of the wheel
// Of a cap that is held as far as it goes, in a second.
constexpr double turnPerSteering = 2;    // [rad]
constexpr double shiftPerSteering = 1.5; // heights of what is seen
constexpr double zoomPerSteering = 1.5;  // as a power of e

} // namespace

Navigator::Navigator(QObject* parent) : QObject(parent) {
  flight_.setDuration(200);
  flight_.setStartValue(0.0);
  flight_.setEndValue(1.0);
  flight_.setEasingCurve(QEasingCurve::InOutCubic);
  connect(&flight_, &QVariantAnimation::valueChanged, this, [this](const QVariant& part) {
    camera_ = between(from_, to_, part.toDouble());
    emit moved();
  });
}

void Navigator::set(const Camera& camera) {
  flight_.stop();
  camera_ = camera;
  emit moved();
}

void Navigator::flyTo(const Camera& camera) {
  flight_.stop();
  from_ = camera_;
  to_ = camera;
  flight_.start();
}

void Navigator::begin(Gesture gesture, const QPointF& at, const Eigen::Vector3d& anchor) {
  flight_.stop();
  gesture_ = gesture;
  last_ = at;
  anchor_ = anchor;
  if (gesture == Gesture::turn) keepPivotSeen();
}

/// A pivot that was left behind by panning would swing the plant out of sight.
void Navigator::keepPivotSeen() {
  const Eigen::Vector2d size(screen_.width(), screen_.height());
  const auto pivot = ScreenMap(camera_, size).project(camera_.pivot);
  const bool seen =
      pivot && (pivot->pixel.array() >= 0).all() && (pivot->pixel.array() <= size.array()).all();
  if (!seen) camera_.pivot = camera_.focus;
}

void Navigator::drag(const QPointF& to) {
  const QPointF by = to - last_;
  last_ = to;
  const double pixel = camera_.halfHeight() / (screen_.height() / 2);
  switch (gesture_) {
  case Gesture::turn:
    camera_.turn(-turnPerPixel * by.x(), turnPerPixel * by.y());
    break;
  case Gesture::pan:
    camera_.pan(pixel * by.x(), -pixel * by.y());
    break;
  case Gesture::zoom:
    zoom(std::exp(-zoomPerPixel * by.y()), anchor_);
    break;
  case Gesture::none:
    return;
  }
  emit moved();
}

void Navigator::zoom(double factor, const Eigen::Vector3d& anchor) {
  const double least = 1e-4 * extent_;
  const double most = 20 * extent_;
  const double before = camera_.distance;
  // A camera that is already beyond the limits may come back, but not go on.
  const double after = std::clamp(before / factor, std::min(least, before), std::max(most, before));
  camera_.zoom(before / after, anchor);
}

void Navigator::pinch(double factor) {
  zoom(factor, anchor_);
  emit moved();
}

void Navigator::steer(const Steering& by) {
  flight_.stop();
  keepPivotSeen();
  camera_.turn(-turnPerSteering * by.turn.y(), turnPerSteering * by.turn.x());
  const double height = 2 * camera_.halfHeight();
  camera_.pan(shiftPerSteering * height * by.shift.x(), shiftPerSteering * height * by.shift.y());
  zoom(std::exp(-zoomPerSteering * by.shift.z()), camera_.focus);
  emit moved();
}

void Navigator::wheel(double steps, const Eigen::Vector3d& anchor) {
  flight_.stop();
  zoom(std::exp(zoomPerStep * steps), anchor);
  emit moved();
}

} // namespace espalier
