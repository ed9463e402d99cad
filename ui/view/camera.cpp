#include "ui/view/camera.h"

#include "core/graph/turn_upright.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {
namespace {

constexpr double quarterTurn = std::numbers::pi / 2;

/// The same direction with an angle in [-pi, pi].
double wrapped(double angle) {
  return std::remainder(angle, 2 * std::numbers::pi);
}

/// From the frame in which z is up to that of the file, in which `up` is.
Eigen::Matrix3d fromUpright(UpAxis up) {
  return turnUpright(up).transpose();
}

/// Rows: right, up, backward.
Eigen::Matrix3d axes(const Camera& camera) {
  Eigen::Matrix3d rows;
  rows << camera.right().transpose(), camera.up().transpose(), -camera.forward().transpose();
  return rows;
}

} // namespace

Eigen::Vector3d Camera::right() const {
  return fromUpright(upAxis) * Eigen::Vector3d(std::cos(yaw), std::sin(yaw), 0);
}

Eigen::Vector3d Camera::up() const {
  return fromUpright(upAxis) * Eigen::Vector3d(-std::sin(yaw) * std::sin(pitch),
                                               std::cos(yaw) * std::sin(pitch), std::cos(pitch));
}

Eigen::Vector3d Camera::forward() const {
  return fromUpright(upAxis) * Eigen::Vector3d(-std::sin(yaw) * std::cos(pitch),
                                               std::cos(yaw) * std::cos(pitch), -std::sin(pitch));
}

double Camera::halfHeight() const {
  return distance * std::tan(fieldOfView / 2);
}

void Camera::turn(double byYaw, double byPitch) {
  const Eigen::Vector3d held = axes(*this) * (focus - pivot);
  yaw = wrapped(yaw + byYaw);
  pitch = std::clamp(pitch + byPitch, -quarterTurn, quarterTurn);
  focus = pivot + axes(*this).transpose() * held;
}

void Camera::pan(double toRight, double toUp) {
  focus -= toRight * right() + toUp * up();
}

void Camera::zoom(double factor, const Eigen::Vector3d& anchor) {
  focus = anchor + (focus - anchor) / factor;
  distance /= factor;
}

void Camera::frame(const std::vector<Eigen::Vector3d>& places, double aspect) {
  constexpr double margin = 1.08;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& place : places)
    box.extend(place);
  focus = pivot = box.center();
  const Eigen::Matrix3d toView = axes(*this);
  const double slope = std::tan(fieldOfView / 2);
  distance = 0;
  for (const Eigen::Vector3d& place : places) {
    const Eigen::Vector3d at = toView * (place - focus);
    const double reach = std::max(std::abs(at.y()), std::abs(at.x()) / aspect) * margin / slope;
    distance = std::max(distance, projection == Projection::perspective ? reach + at.z() : reach);
  }
  // A single node has no size: show about a unit around it.
  if (!(distance > 0)) distance = 1;
}

void Camera::frame(const Eigen::AlignedBox3d& box, double aspect) {
  std::vector<Eigen::Vector3d> corners;
  corners.reserve(8);
  for (int i = 0; i < 8; ++i)
    corners.emplace_back(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i)));
  frame(corners, aspect);
}

void Camera::face(StandardView view) {
  const double keptYaw = yaw;
  const Eigen::Vector3d held = axes(*this) * (focus - pivot);
  pitch = 0;
  switch (view) {
  case StandardView::front:
    yaw = 0;
    break;
  case StandardView::back:
    yaw = std::numbers::pi;
    break;
  case StandardView::left:
    yaw = -quarterTurn;
    break;
  case StandardView::right:
    yaw = quarterTurn;
    break;
  case StandardView::top:
    yaw = 0;
    pitch = quarterTurn;
    break;
  case StandardView::bottom:
    yaw = 0;
    pitch = -quarterTurn;
    break;
  case StandardView::isometric:
    yaw = std::numbers::pi / 4;
    pitch = std::atan(std::numbers::sqrt2 / 2);
    break;
  }
  yaw = keptYaw + wrapped(yaw - keptYaw);
  focus = pivot + axes(*this).transpose() * held;
}

void Camera::faceBroadside(const std::vector<Eigen::Vector3d>& places) {
  constexpr double flat = 2.5; // as far across as deep
  if (places.size() < 3) return;
  Eigen::Matrix2Xd level(2, static_cast<Eigen::Index>(places.size()));
  for (std::size_t i = 0; i < places.size(); ++i)
    level.col(static_cast<Eigen::Index>(i)) =
        (fromUpright(upAxis).transpose() * places[i]).head<2>();
  level.colwise() -= level.rowwise().mean().eval();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> spread(level * level.transpose());
  if (!(spread.eigenvalues()[1] > flat * flat * spread.eigenvalues()[0])) return;
  const Eigen::Vector2d thin = spread.eigenvectors().col(0);
  double by = wrapped(std::atan2(-thin.x(), thin.y()) - yaw); // forward() along it
  if (std::abs(by) > quarterTurn) by = wrapped(by + std::numbers::pi);
  turn(by, 0);
}

Eigen::Matrix4d Camera::viewMatrix(const Eigen::Vector3d& origin) const {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = axes(*this);
  // Subtracted in double before it is turned: this is where large coordinates lose their size.
  matrix.topRightCorner<3, 1>() = -(axes(*this) * (eye() - origin));
  if (projection == Projection::perspective)
    matrix(0, 3) -= aside * distance;
  else { // what is before the focus goes to the left, what is behind it to the right
    matrix.row(0) -= aside * matrix.row(2);
    matrix(0, 3) -= aside * distance;
  }
  return matrix;
}

Eigen::Matrix4d Camera::projectionMatrix(double aspect, const DepthRange& depths) const {
  const double n = depths.nearest;
  const double f = depths.farthest;
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  if (projection == Projection::perspective) {
    const double scale = 1 / std::tan(fieldOfView / 2);
    matrix.diagonal() << scale / aspect, scale, -(f + n) / (f - n), 0;
    matrix(2, 3) = -2 * f * n / (f - n);
    matrix(3, 2) = -1;
    matrix(0, 2) = -scale / aspect * aside;
  } else {
    const double scale = 1 / halfHeight();
    matrix.diagonal() << scale / aspect, scale, -2 / (f - n), 1;
    matrix(2, 3) = -(f + n) / (f - n);
  }
  return matrix;
}

DepthRange Camera::depthsOf(const Eigen::AlignedBox3d& box) const {
  double nearest = distance;
  double farthest = distance;
  for (int corner = 0; corner < 8 && !box.isEmpty(); ++corner) {
    const double depth =
        forward().dot(box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(corner)) - eye());
    nearest = std::min(nearest, depth);
    farthest = std::max(farthest, depth);
  }
  const double slack = 0.05 * (farthest - nearest) + 0.01 * distance; // for spheres and frusta
  nearest -= slack;
  farthest += slack;
  if (projection == Projection::perspective) {
    farthest = std::max(farthest, 0.1 * distance);
    nearest = std::max({nearest, 1e-3 * distance, 1e-5 * farthest});
  }
  return {nearest, farthest};
}

Camera between(const Camera& from, const Camera& to, double part) {
  if (part >= 1) return to;
  Camera camera = to;
  camera.yaw = from.yaw + part * wrapped(to.yaw - from.yaw);
  camera.pitch = from.pitch + part * (to.pitch - from.pitch);
  camera.focus = from.focus + part * (to.focus - from.focus);
  camera.pivot = from.pivot + part * (to.pivot - from.pivot);
  camera.distance = from.distance * std::pow(to.distance / from.distance, part);
  return camera;
}

ScreenMap::ScreenMap(const Camera& camera, const Eigen::Vector2d& size)
    : camera_(camera), eye_(camera.eye()), right_(camera.right()), up_(camera.up()),
      forward_(camera.forward()), middle_(size / 2), scale_(camera.halfHeight() / (size.y() / 2)),
      perspective_(camera.projection == Projection::perspective) {
  if (perspective_) scale_ /= camera.distance;
}

double ScreenMap::pixelSize(double depth) const {
  return perspective_ ? scale_ * depth : scale_;
}

std::optional<ScreenMap::Place> ScreenMap::project(const Eigen::Vector3d& place) const {
  const Eigen::Vector3d offset = place - eye_;
  const double depth = forward_.dot(offset);
  if (perspective_ && !(depth > 0)) return std::nullopt;
  const Eigen::Vector2d shift(right_.dot(offset), -up_.dot(offset));
  return Place{middle_ + shift / pixelSize(depth), depth};
}

Eigen::Matrix<double, 3, 4> ScreenMap::toScreen(const Eigen::Vector3d& origin) const {
  Eigen::Matrix<double, 3, 4> matrix;
  matrix.row(0).head<3>() = right_ / scale_;
  matrix.row(1).head<3>() = -up_ / scale_;
  matrix.row(2).head<3>() = forward_;
  matrix.col(3) = matrix.leftCols<3>() * (origin - eye_);
  return matrix;
}

Eigen::ParametrizedLine<double, 3> ScreenMap::ray(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector2d shift = (pixel - middle_) * scale_;
  const Eigen::Vector3d aside = shift.x() * right_ - shift.y() * up_;
  if (perspective_) return {eye_, (forward_ + aside).normalized()};
  return {eye_ + aside, forward_};
}

Eigen::Vector3d ScreenMap::place(const Eigen::Vector2d& pixel, double depth) const {
  const auto line = ray(pixel);
  return line.pointAt(depth / line.direction().dot(forward_));
}

} // namespace espalier
