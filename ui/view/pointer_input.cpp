#include "ui/view/pointer_input.h"

#include "core/cloud/isolated_points.h"
#include "ui/view/skeleton_picker.h"
#include "ui/view/visibility.h"

#include <QLineF>

#include <utility>

namespace espalier {
namespace {

constexpr double skeletonReach = 10; // [logical pixels]
constexpr double pointReach = 6;
constexpr double thingReach = 2; // about what a point is drawn with
constexpr double clickReach = 3; // a press that moves less is a click

Navigator::Gesture gestureOf(Qt::MouseButton button) {
  switch (button) {
  case Qt::LeftButton:
    return Navigator::Gesture::turn;
  case Qt::RightButton:
    return Navigator::Gesture::pan;
  case Qt::MiddleButton:
    return Navigator::Gesture::zoom;
  default:
    return Navigator::Gesture::none;
  }
}

/// Ctrl is, but with Shift or Alt it draws areas that take all, however deep.
bool isForCamera(Qt::KeyboardModifiers modifiers) {
  return modifiers.testFlag(Qt::ControlModifier) && !modifiers.testFlag(Qt::ShiftModifier) &&
         !modifiers.testFlag(Qt::AltModifier);
}

double extentOf(const Scene& scene) {
  const Eigen::AlignedBox3d box = scene.bounds();
  const double extent = box.isEmpty() ? 0 : box.diagonal().norm();
  return extent > 0 ? extent : 1;
}

/// Points that may be under the pointer.
struct Pickable {
  const DrawnPoints& points;
  const PointHierarchy& boxes;
  std::function<bool(Eigen::Index)> isShown;
};

/// Does a point float free: are fewer than five others near it?
bool isStray(const Pickable& layer, Eigen::Index point, double spacing) {
  constexpr int company = 5;
  const auto& positions = *layer.points.positions;
  const Eigen::Vector3f place = positions.col(point);
  const double reach = IsolatedPointOptions::usualDistance * spacing;
  const auto most = static_cast<float>(reach * reach);
  int near = 0; // with the point itself
  layer.boxes.forEachRun(
      [&](const auto& box) {
        return near <= company && box.squaredExteriorDistance(place) <= most;
      },
      [&](Eigen::Index begin, Eigen::Index end) {
        for (Eigen::Index i = begin; i < end; ++i)
          near += (positions.col(i) - place).squaredNorm() <= most ? 1 : 0;
      });
  return near <= company;
}

/// The point under a pixel: its column.
/// @param toFile from the points of the layer to the frame of the file
/// @param reach  around it [logical pixels]
std::optional<Eigen::Index> columnUnder(const Pickable& layer, const Eigen::Isometry3d& toFile,
                                        const ScreenMap& map, const Eigen::Vector2d& pixel,
                                        double reach = pointReach) {
  if (layer.points.size() == 0) return std::nullopt;
  Eigen::ParametrizedLine<double, 3> ray = map.ray(pixel);
  ray = {toFile.inverse() * ray.origin(), toFile.linear().transpose() * ray.direction()};
  const double slope = reach * (map.pixelSize(2) - map.pixelSize(1)); // 0 if parallel
  const double radius = reach * map.pixelSize(0);
  // In parallel projection, what is behind the plane of the eye is drawn as well.
  const auto box = layer.boxes.bounds();
  const double back = map.isPerspective() ? 0
                                          : (box.center().cast<double>() - ray.origin()).norm() +
                                                box.diagonal().norm();
  const Eigen::Vector3d apex = ray.pointAt(-back);
  const ViewCone cone{apex.cast<float>(), ray.direction().cast<float>(), static_cast<float>(radius),
                      static_cast<float>(slope)};
  return layer.boxes.pick(*layer.points.positions, cone, layer.isShown);
}

/// Where it is, in the frame of the file.
std::optional<Eigen::Vector3d> pointUnder(const Pickable& layer, const Eigen::Vector3d& origin,
                                          const ScreenMap& map, const Eigen::Vector2d& pixel,
                                          double reach = pointReach) {
  const Eigen::Isometry3d toFile(Eigen::Translation3d{origin});
  const auto found = columnUnder(layer, toFile, map, pixel, reach);
  if (!found) return std::nullopt;
  return layer.points.positions->col(*found).cast<double>() + origin;
}

/// The same, but of what the pointer is on rather than of what is near it and before it, and of
/// what is behind where strays float before it.
std::optional<Eigen::Vector3d> pointOfThing(const Pickable& layer, double spacing,
                                            const Eigen::Vector3d& origin, const ScreenMap& map,
                                            const Eigen::Vector2d& pixel) {
  const Pickable things{layer.points, layer.boxes, [&](Eigen::Index i) {
                          return layer.isShown(i) && !isStray(layer, i, spacing);
                        }};
  auto place = pointUnder(things, origin, map, pixel, thingReach);
  if (!place) place = pointUnder(things, origin, map, pixel);
  return place ? place : pointUnder(layer, origin, map, pixel);
}

/// Where a pick is; a node or edge before a point.
std::optional<Eigen::Vector3d> placeOf(const Pick& pick, const SkeletonGlyphs& glyphs) {
  if (pick.node) return glyphs.position(indexOf(*pick.node));
  if (pick.edge) return pick.edge->position;
  return pick.point;
}

} // namespace

void PointerInput::setSize(const QSizeF& size) {
  size_ = size.expandedTo({1, 1});
  navigator_.setScreen(size_);
}

ScreenMap PointerInput::screen() const {
  return {navigator_.camera(), {size_.width(), size_.height()}};
}

Pick PointerInput::pick(const QPointF& position) const {
  const Eigen::Vector2d pixel(position.x(), position.y());
  const ScreenMap map = screen();
  const ClipVolume clip = scene_.clipVolume(map.camera());
  Pick pick;
  if (scene_.skeletonVisible && depth_ == Depth::through) {
    pick = pickSkeleton(scene_.skeleton, map, pixel, skeletonReach, nullptr, clip);
  } else if (scene_.skeletonVisible) {
    const QPointF reach(skeletonReach, skeletonReach);
    const Visibility visibility(scene_, map, QRectF(position - reach, position + reach));
    pick = pickSkeleton(scene_.skeleton, map, pixel, skeletonReach, &visibility, clip);
  }
  pick = ofPlant(pick, position);
  pickPoint(pick, map, pixel);
  if (!pick.pointOfThing) pick.pointOfThing = pick.point;
  return pick;
}

/// Of the layers that are drawn there: as scanned, contracted, or contracted by another state.
void PointerInput::pickPoint(Pick& pick, const ScreenMap& map, const Eigen::Vector2d& pixel) const {
  const Eigen::Vector3d origin = scene_.origin();
  const ClipVolume clip = scene_.clipVolume(map.camera());
  const FocusDepths focus = scene_.focusDepths(map.camera());
  const auto isPassed = [&](const Eigen::Vector3d& place) {
    return focus.isPassed((place - map.camera().eye()).dot(map.camera().forward()));
  };
  const double across = pixel.x() / size_.width();
  const auto placeIn = [&](const DrawnPoints& points, Eigen::Index i) {
    return Eigen::Vector3d(points.positions->col(i).cast<double>() + origin);
  };
  const PointLayer& points = scene_.points;
  if (points.visible) {
    const Pickable scanned{points, points.boxes, [&](Eigen::Index i) {
                             return scene_.isPointShown(i) &&
                                    clip.contains(points.positions->col(i)) &&
                                    !isPassed(placeIn(points, i)) &&
                                    scene_.showsScanned(placeIn(points, i), across, divider_);
                           }};
    pick.point = pointUnder(scanned, origin, map, pixel);
    if (pick.point) pick.pointOfThing = pointOfThing(scanned, points.spacing, origin, map, pixel);
  }
  const PointLayer& contracted = scene_.contracted;
  if (!pick.point && contracted.visible)
    pick.point = pointUnder({contracted, contracted.boxes,
                             [&](Eigen::Index i) {
                               return scene_.isContractedShown(i) &&
                                      clip.contains(contracted.positions->col(i)) &&
                                      !isPassed(placeIn(contracted, i)) &&
                                      scene_.showsPlant(placeIn(contracted, i), across, divider_);
                             }},
                            origin, map, pixel);
  if (scene_.moved.isShown()) {
    const Eigen::Isometry3d placement = scene_.movedPlacement();
    pick.movedPoint = columnUnder({scene_.moved, scene_.moved.boxes,
                                   [&](Eigen::Index i) {
                                     const Eigen::Vector3d at =
                                         placement * scene_.moved.positions->col(i).cast<double>();
                                     return clip.contains(at.cast<float>());
                                   }},
                                  Eigen::Translation3d(origin) * placement, map, pixel);
  }
  const OtherState& other = scene_.other(across < divider_ ? Side::left : Side::right);
  if (pick.point || !other.isShown || !(other.replacesPoints || contracted.visible)) return;
  pick.point =
      pointUnder({other.contracted, other.boxes,
                  [&](Eigen::Index i) {
                    const auto column = static_cast<std::size_t>(i);
                    return scene_.isPointShown(other.points.empty() ? i : other.points[column]) &&
                           !isPassed(placeIn(other.contracted, i)) &&
                           clip.contains(other.contracted.positions->col(i));
                  }},
                 origin, map, pixel);
  pick.isOfOther = pick.point.has_value();
}

Pick PointerInput::ofPlant(const Pick& pick, const QPointF& position) const {
  const std::optional<Eigen::Vector3d> place = placeOf(pick, scene_.skeleton);
  const bool isShown = place && scene_.showsPlant(*place, position.x() / size_.width(), divider_);
  return isShown ? pick : Pick{};
}

ToolInput PointerInput::input(ToolInput::Phase phase, const Pointer& pointer,
                              const Pick& pick) const {
  const ScreenMap map = screen();
  return {.phase = phase,
          .ray = map.ray({pointer.position.x(), pointer.position.y()}),
          .viewDirection = map.forward(),
          .pick = pick,
          .button = pointer.button,
          .modifiers = pointer.modifiers,
          .depth = pointer.modifiers.testFlag(Qt::ControlModifier) ? Depth::through : depth_,
          .screen = pointer.position};
}

bool PointerInput::notify(ToolInput::Phase phase, const Pointer& pointer, const Pick& pick) {
  return handler_ && handler_(input(phase, pointer, pick));
}

Eigen::Vector3d PointerInput::zoomAnchor(const QPointF& position, const Pick& pick) const {
  if (const auto place = placeOf(pick, scene_.skeleton)) return *place;
  return screen().place({position.x(), position.y()}, navigator_.camera().distance);
}

void PointerInput::press(const QMouseEvent& event) {
  if (isBusy()) return; // a second button changes nothing
  const QPointF position = event.position();
  button_ = event.button();
  pressed_ = last_ = position;
  dragged_ = false;
  cameraOnly_ = isForCamera(event.modifiers());
  const Pick under = pick(position);
  taken_ = !cameraOnly_ &&
           notify(ToolInput::Phase::press, {position, button_, event.modifiers()}, under);
  navigator_.setExtent(extentOf(scene_));
  if (!taken_) navigator_.begin(gestureOf(button_), position, zoomAnchor(position, under));
}

void PointerInput::move(const QMouseEvent& event) {
  const QPointF position = event.position();
  const Pointer pointer{position, button_, event.modifiers()};
  last_ = position;
  isInside_ = true;
  if (!isBusy()) {
    notify(ToolInput::Phase::hover, pointer, pick(position));
    return;
  }
  if (!cameraOnly_) notify(ToolInput::Phase::drag, pointer, taken_ ? pick(position) : Pick());
  dragged_ = dragged_ || QLineF(pressed_, position).length() > clickReach;
  if (!taken_ && dragged_) navigator_.drag(position);
}

void PointerInput::release(const QMouseEvent& event) {
  if (event.button() != button_ || !isBusy()) return;
  const Pointer pointer{event.position(), std::exchange(button_, Qt::NoButton), event.modifiers()};
  navigator_.end();
  if (!cameraOnly_) notify(ToolInput::Phase::release, pointer, pick(event.position()));
}

std::optional<Eigen::Vector3d> PointerInput::doubleClick(const QMouseEvent& event) {
  const Pick under = pick(event.position());
  const Pointer pointer{event.position(), event.button(), event.modifiers()};
  const bool cameraOnly = isForCamera(event.modifiers());
  if (!cameraOnly && notify(ToolInput::Phase::doubleClick, pointer, under)) return std::nullopt;
  if (event.button() != Qt::LeftButton) return std::nullopt;
  return placeOf(under, scene_.skeleton);
}

Eigen::Vector3d PointerInput::zoomAnchor(const QPointF& position) {
  navigator_.setExtent(extentOf(scene_));
  return zoomAnchor(position, pick(position));
}

void PointerInput::wheel(const QWheelEvent& event) {
  navigator_.wheel(event.angleDelta().y() / 120.0, zoomAnchor(event.position()));
}

void PointerInput::leave() {
  isInside_ = false;
  if (!isBusy()) notify(ToolInput::Phase::hover, {last_, Qt::NoButton, Qt::NoModifier}, {});
}

void PointerInput::hoverAgain() {
  if (!isBusy() && isInside_)
    notify(ToolInput::Phase::hover, {last_, Qt::NoButton, Qt::NoModifier}, pick(last_));
}

void PointerInput::cancel() {
  if (!isBusy()) return;
  const Pointer pointer{last_, std::exchange(button_, Qt::NoButton), Qt::NoModifier};
  navigator_.end();
  if (!cameraOnly_) notify(ToolInput::Phase::cancel, pointer, {});
}

} // namespace espalier
