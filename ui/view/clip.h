#pragma once

#include "ui/view/camera.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <limits>
#include <optional>

namespace espalier {

/// Which part of a plant is shown: what lies in the slab and in the box.
struct Clip {
  /// Faces the viewer, and turns with the camera. Parts of the depth of the plant, 0 its front.
  struct Slab {
    double nearest = 0;
    double farthest = 1; // >= nearest
    bool operator==(const Slab&) const = default;
  };
  std::optional<Slab> slab;
  std::optional<Eigen::AlignedBox3d> box; // [L], frame of the file

  [[nodiscard]] bool isAll() const { return !slab && !box; }
  bool operator==(const Clip& other) const;
};

/// A clip as it lies before a camera. Places are about an origin.
class ClipVolume {
public:
  ClipVolume() = default; // holds everything
  /// @param bounds of the plant [L], frame of the file
  ClipVolume(const Clip& clip, const Eigen::AlignedBox3d& bounds, const Eigen::Vector3d& origin,
             const Camera& camera);

  [[nodiscard]] bool isAll() const { return isAll_; }
  [[nodiscard]] bool contains(const Eigen::Vector3f& place) const {
    if (isAll_) return true;
    const float depth = forward_.dot(place) - eye_;
    return depth >= depths_[0] && depth <= depths_[1] && (place.array() >= low_.array()).all() &&
           (place.array() <= high_.array()).all();
  }

  // What the shaders are given.
  [[nodiscard]] const Eigen::Vector2f& depths() const { return depths_; } // [L], from the eye
  [[nodiscard]] const Eigen::Vector3f& low() const { return low_; }
  [[nodiscard]] const Eigen::Vector3f& high() const { return high_; }

  bool operator==(const ClipVolume&) const = default;

private:
  static constexpr float far = 1e30F;

  bool isAll_ = true;
  Eigen::Vector3f forward_ = Eigen::Vector3f::UnitY();
  float eye_ = 0; // how far along `forward_` the eye is
  Eigen::Vector2f depths_{-far, far};
  Eigen::Vector3f low_ = Eigen::Vector3f::Constant(-far);
  Eigen::Vector3f high_ = Eigen::Vector3f::Constant(far);
};

} // namespace espalier
