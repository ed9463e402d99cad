#pragma once

#include "core/graph/find_root.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <optional>
#include <vector>

namespace espalier {

enum class Projection { perspective, parallel };
enum class StandardView { front, back, left, right, top, bottom, isometric };

/// How far from the eye drawn things begin and end [L].
struct DepthRange {
  double nearest;
  double farthest;
};

/// A turntable camera: the plant stands along `upAxis`, always. A value; its acts keep what the
/// user holds on to in place.
///
/// With yaw and pitch 0 it looks at the front of the plant: along +y, x to the right, where z is
/// up; along -z, x to the right, where y is; along +z, y to the right, where x is.
struct Camera {
  static constexpr double fieldOfView = 0.6; // [rad], vertical

  Eigen::Vector3d focus = Eigen::Vector3d::Zero(); // [L], in the middle of the screen
  Eigen::Vector3d pivot = Eigen::Vector3d::Zero(); // [L], what turns turn around
  double distance = 1;                             // [L], from the eye to the focus, > 0
  double yaw = 0;   // [rad], about the axis that is up, counterclockwise from above
  double pitch = 0; // [rad], in [-pi/2, pi/2]; positive looks down on the plant
  Projection projection = Projection::perspective;
  UpAxis upAxis = UpAxis::z; // of the frame of the file
  /// How far to the right of the eye it is drawn from, by the distance: for one of two eyes. The
  /// plane of the focus stays where it is on the screen.
  double aside = 0;

  [[nodiscard]] Eigen::Vector3d right() const;
  [[nodiscard]] Eigen::Vector3d up() const;
  [[nodiscard]] Eigen::Vector3d forward() const; // into the screen
  [[nodiscard]] Eigen::Vector3d eye() const { return focus - distance * forward(); }

  /// Half of what the screen shows from top to bottom, at the focus [L].
  [[nodiscard]] double halfHeight() const;

  /// Turns about the pivot, which stays where it is on the screen.
  void turn(double byYaw, double byPitch);
  /// Shifts the plant with the pointer, at the depth of the focus [L].
  void pan(double toRight, double toUp);
  /// Makes things `factor` times as large on the screen; `anchor` stays where it is on it.
  void zoom(double factor, const Eigen::Vector3d& anchor); // pre: factor > 0
  /// Shows all of these places, and takes the middle of their box as the pivot.
  /// @param places not empty
  /// @param aspect width of the screen over its height
  void frame(const std::vector<Eigen::Vector3d>& places, double aspect);
  void frame(const Eigen::AlignedBox3d& box, double aspect); // all of its corners
  void face(StandardView view);
  /// Turns about the pivot to look along the horizontal direction in which these places reach
  /// least, if they reach much farther across it: so a branch that was scanned lying flat is not
  /// seen edge on. The less it turns for that the better.
  void faceBroadside(const std::vector<Eigen::Vector3d>& places);

  /// From the frame of the file, less `origin`, to that of the eye (x right, y up, z backward).
  [[nodiscard]] Eigen::Matrix4d viewMatrix(const Eigen::Vector3d& origin) const;
  /// From the frame of the eye to OpenGL's clip space.
  [[nodiscard]] Eigen::Matrix4d projectionMatrix(double aspect, const DepthRange& depths) const;
  /// Encloses the box as seen from here; within what a depth buffer can resolve.
  [[nodiscard]] DepthRange depthsOf(const Eigen::AlignedBox3d& box) const;

  bool operator==(const Camera&) const = default;
};

/// The camera between two others, for `part` in [0, 1]; turns by the smaller angle.
[[nodiscard]] Camera between(const Camera& from, const Camera& to, double part);

/// Where places are on a screen of `size` logical pixels, y downward, and back.
class ScreenMap {
public:
  ScreenMap(const Camera& camera, const Eigen::Vector2d& size);

  struct Place {
    Eigen::Vector2d pixel;
    double depth; // [L], along the view direction
  };
  /// None for what is not in front of the eye.
  [[nodiscard]] std::optional<Place> project(const Eigen::Vector3d& place) const;
  /// From the eye (parallel: from the plane of the eye) through a pixel; unit direction.
  [[nodiscard]] Eigen::ParametrizedLine<double, 3> ray(const Eigen::Vector2d& pixel) const;
  /// Width of a pixel at a depth [L].
  [[nodiscard]] double pixelSize(double depth) const;
  [[nodiscard]] const Eigen::Vector3d& forward() const { return forward_; }
  [[nodiscard]] const Camera& camera() const { return camera_; }
  [[nodiscard]] const Eigen::Vector3d& eye() const { return eye_; }
  [[nodiscard]] bool isPerspective() const { return perspective_; }
  [[nodiscard]] Eigen::Vector2d size() const { return 2 * middle_; } // [logical pixels]
  /// Of a place less `origin`: its depth [L] in the last row, and in the others its pixel from the
  /// middle of the screen, in perspective times its depth.
  [[nodiscard]] Eigen::Matrix<double, 3, 4> toScreen(const Eigen::Vector3d& origin) const;
  /// The place at `depth` behind a pixel.
  [[nodiscard]] Eigen::Vector3d place(const Eigen::Vector2d& pixel, double depth) const;

private:
  Camera camera_;
  Eigen::Vector3d eye_, right_, up_, forward_;
  Eigen::Vector2d middle_;
  double scale_; // [L] a pixel, at depth 1 in perspective
  bool perspective_;
};

} // namespace espalier
