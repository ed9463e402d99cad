#pragma once

#include "ui/view/camera.h"

#include <QRectF>

#include <algorithm>

namespace espalier {

/// A part of the screen, to find fast which of many places are in it. Places are about an origin.
class ScreenPart {
public:
  /// @param part [logical pixels]; what of it is off the screen is left out
  ScreenPart(const ScreenMap& screen, const Eigen::Vector3d& origin, const QRectF& part)
      : toScreen_(screen.toScreen(origin).cast<float>()), perspective_(screen.isPerspective()),
        perPixel_(1 / static_cast<float>(screen.pixelSize(1))) {
    const Eigen::Vector2d size = screen.size();
    box_ = part & QRectF(0, 0, size.x(), size.y());
    middle_ = {static_cast<float>(size.x() / 2 - box_.left()),
               static_cast<float>(size.y() / 2 - box_.top())};
  }

  [[nodiscard]] const QRectF& box() const { return box_; } // [logical pixels]; may be empty

  struct Place {
    Eigen::Vector2f pixel; // from the corner of the part
    float depth;           // [L], along the view direction; not positive: perhaps behind the eye
  };
  [[nodiscard]] Place place(const Eigen::Vector3f& at) const {
    const Eigen::Vector3f seen = toScreen_.leftCols<3>() * at + toScreen_.col(3);
    const float scale = perspective_ ? 1 / seen.z() : 1;
    return {middle_ + scale * seen.head<2>(), seen.z()};
  }
  [[nodiscard]] bool isBeforeEye(const Place& place) const {
    return !perspective_ || place.depth > 0;
  }

  /// False if nothing within `wider` [L] of a box is in the part.
  [[nodiscard]] bool mayMeet(const Eigen::AlignedBox3f& box, float wider) const {
    const float reach = 0.5F * box.diagonal().norm() + wider;
    const Eigen::Vector3f at = toScreen_.leftCols<3>() * box.center() + toScreen_.col(3);
    const float near = perspective_ ? at.z() - reach : 1;
    const float far = perspective_ ? at.z() + reach : 1;
    if (far <= 0) return false;
    if (near <= 0) return true;
    const float wide = reach * perPixel_;
    const auto meets = [&](float shift, float middle, double length) {
      const float low = std::min((shift - wide) / near, (shift - wide) / far) + middle;
      const float high = std::max((shift + wide) / near, (shift + wide) / far) + middle;
      return high >= 0 && low <= static_cast<float>(length);
    };
    return meets(at.x(), middle_.x(), box_.width()) && meets(at.y(), middle_.y(), box_.height());
  }

private:
  Eigen::Matrix<float, 3, 4> toScreen_;
  bool perspective_;
  float perPixel_; // at depth 1 [1/L]
  QRectF box_;
  Eigen::Vector2f middle_; // of the screen, from the corner of the part
};

} // namespace espalier
