#pragma once

#include "ui/view/camera.h"

#include <QObject>
#include <QPointF>
#include <QSizeF>
#include <QVariantAnimation>

namespace espalier {

/// What a 3D mouse does to the plant: how far its cap was held from its rest, times how long. 1 is
/// as far as it goes, for a second.
struct Steering {
  Eigen::Vector3d shift = Eigen::Vector3d::Zero(); // to the right, up, and away from the eye
  Eigen::Vector2d turn = Eigen::Vector2d::Zero();  // right-handed, about what is right, and up
};

/// Moves the camera: by the hand of the user at once, by the program over 200 ms. A hand on the
/// camera stops what the program does.
class Navigator : public QObject {
  Q_OBJECT

public:
  enum class Gesture { none, turn, pan, zoom };

  explicit Navigator(QObject* parent = nullptr);

  [[nodiscard]] const Camera& camera() const { return camera_; }
  /// Where the camera is, or will be once it has arrived.
  [[nodiscard]] const Camera& destination() const { return isFlying() ? to_ : camera_; }
  [[nodiscard]] Gesture gesture() const { return gesture_; }
  [[nodiscard]] bool isFlying() const { return flight_.state() == QAbstractAnimation::Running; }

  void set(const Camera& camera);
  void flyTo(const Camera& camera);

  void setScreen(const QSizeF& size) { screen_ = size; } // [logical pixels]
  /// How large the plant is [L]: zooms end well within and well outside of it.
  void setExtent(double extent) { extent_ = extent; }
  /// @param anchor what a zoom keeps in place
  void begin(Gesture gesture, const QPointF& at, const Eigen::Vector3d& anchor);
  void drag(const QPointF& to); // pre: a gesture is on
  void end() { gesture_ = Gesture::none; }
  void pinch(double factor);                               // > 1 comes nearer; pre: a gesture is on
  void steer(const Steering& by);                          // the plant
  void wheel(double steps, const Eigen::Vector3d& anchor); // positive comes nearer

signals:
  void moved();

private:
  void keepPivotSeen();
  void zoom(double factor, const Eigen::Vector3d& anchor);

  Camera camera_;
  Camera from_, to_;
  QVariantAnimation flight_;
  Gesture gesture_ = Gesture::none;
  Eigen::Vector3d anchor_ = Eigen::Vector3d::Zero();
  QPointF last_;
  QSizeF screen_{1, 1};
  double extent_ = 1; // [L]
};

} // namespace espalier
