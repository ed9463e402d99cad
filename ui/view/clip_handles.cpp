#include "ui/view/clip_handles.h"

#include "ui/view/overlay_text.h"
#include "ui/view/palette.h"

#include <QCoreApplication>
#include <QLineF>

#include <algorithm>
#include <cmath>
#include <utility>

namespace espalier {
namespace {

using Handle = ClipHandles::Handle;
using Part = ClipHandles::Handle::Part;

// [logical pixels]
constexpr double handleReach = 10;
constexpr double gaugeLeft = 26;
constexpr double gaugeWidth = 8;

constexpr double leastPart = 0.01;         // of its range that a slab or box keeps
constexpr double leastForeshortened = 0.2; // a face that moves along the line of sight has no grip

bool isFace(Part part) {
  return part == Part::lowFace || part == Part::highFace;
}

double coordinateOf(const Eigen::AlignedBox3d& box, const Handle& face) {
  return (face.part == Part::lowFace ? box.min() : box.max())[face.axis];
}

Eigen::Vector3d middleOf(const Eigen::AlignedBox3d& box, const Handle& face) {
  Eigen::Vector3d middle = box.center();
  middle[face.axis] = coordinateOf(box, face);
  return middle;
}

/// Where on the line along an axis through `through` a ray comes nearest to it: the coordinate.
double alongAxis(const Eigen::ParametrizedLine<double, 3>& ray, const Eigen::Vector3d& through,
                 int axis) {
  const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
  const Eigen::Vector3d between = ray.origin() - through;
  const double lean = unit.dot(ray.direction());
  const double square = std::max(1 - lean * lean, 1e-6);
  return through[axis] + (unit.dot(between) - lean * ray.direction().dot(between)) / square;
}

/// The gauge: back of the plant on top, front at the bottom.
QRectF gaugeOf(const ScreenMap& screen) {
  const double height = std::min(200.0, 0.4 * screen.size().y());
  return {gaugeLeft, (screen.size().y() - height) / 2, gaugeWidth, height};
}

double placeOn(const QRectF& gauge, double depth) {
  return gauge.bottom() - depth * gauge.height();
}

double depthOn(const QRectF& gauge, double place) {
  return (gauge.bottom() - place) / gauge.height();
}

/// Where along its line a pointer holds a handle: [L] along the axis, or a part of the depth.
double heldAt(const ClipHandles::Sight& sight, const Clip& clip, const Handle& handle,
              const QPointF& place) {
  if (!isFace(handle.part)) return depthOn(gaugeOf(sight.screen), place.y());
  return alongAxis(sight.screen.ray({place.x(), place.y()}), middleOf(*clip.box, handle),
                   handle.axis);
}

Clip::Slab movedSlab(const Clip::Slab& slab, Part part, double by) {
  if (part == Part::front)
    return {std::clamp(slab.nearest + by, 0.0, slab.farthest - leastPart), slab.farthest};
  if (part == Part::back)
    return {slab.nearest, std::clamp(slab.farthest + by, slab.nearest + leastPart, 1.0)};
  const double held = std::clamp(by, -slab.nearest, 1 - slab.farthest);
  return {slab.nearest + held, slab.farthest + held};
}

Eigen::AlignedBox3d movedBox(Eigen::AlignedBox3d box, const Eigen::AlignedBox3d& bounds,
                             const Handle& face, double by) {
  const int axis = face.axis;
  const double size = std::max(bounds.sizes()[axis], 1e-9);
  const double least = leastPart * size;
  const double moved = coordinateOf(box, face) + by;
  // A little beyond the plant, so that it may be seen whole; not back in, if it was farther out.
  if (face.part == Part::lowFace)
    box.min()[axis] =
        std::min(std::max(moved, std::min(bounds.min()[axis] - 0.05 * size, box.min()[axis])),
                 box.max()[axis] - least);
  else
    box.max()[axis] =
        std::max(std::min(moved, std::max(bounds.max()[axis] + 0.05 * size, box.max()[axis])),
                 box.min()[axis] + least);
  return box;
}

} // namespace

void ClipHandles::setShown(bool isShown) {
  isShown_ = isShown;
  if (!isShown) {
    hovered_.reset();
    drag_.reset();
  }
}

std::vector<ClipHandles::Grip> ClipHandles::grips(const Sight& sight) {
  std::vector<Grip> grips;
  if (sight.clip.slab) {
    const QRectF gauge = gaugeOf(sight.screen);
    const double x = gauge.center().x();
    const Clip::Slab& slab = *sight.clip.slab;
    grips.push_back({{Part::front, 0}, {x, placeOn(gauge, slab.nearest)}, {0, 1}});
    grips.push_back({{Part::back, 0}, {x, placeOn(gauge, slab.farthest)}, {0, -1}});
  }
  for (int axis = 0; axis < 3 && sight.clip.box; ++axis)
    for (const Part part : {Part::lowFace, Part::highFace}) {
      const Handle handle{part, axis};
      const Eigen::Vector3d middle = middleOf(*sight.clip.box, handle);
      const double step = std::max(sight.clip.box->diagonal().norm(), 1e-9) / 100;
      const double outward = part == Part::lowFace ? -step : step;
      const auto found = sight.screen.project(middle);
      const auto beyond = pixelOf(sight.screen, middle + outward * Eigen::Vector3d::Unit(axis));
      if (!found || !beyond) continue;
      const QPointF place(found->pixel.x(), found->pixel.y());
      const QLineF outwardLine(place, *beyond);
      if (outwardLine.length() * sight.screen.pixelSize(found->depth) < leastForeshortened * step)
        continue;
      grips.push_back(
          {handle, place, (outwardLine.p2() - outwardLine.p1()) / outwardLine.length()});
    }
  return grips;
}

std::optional<Handle> ClipHandles::at(const Sight& sight, const QPointF& place) const {
  if (!isShown_) return std::nullopt;
  std::optional<Handle> nearest;
  double least = handleReach;
  for (const Grip& grip : grips(sight)) {
    const double distance = QLineF(grip.place, place).length();
    if (distance > least) continue;
    least = distance;
    nearest = grip.handle;
  }
  if (nearest || !sight.clip.slab) return nearest;
  const QRectF gauge = gaugeOf(sight.screen);
  const double depth = depthOn(gauge, place.y());
  const bool isOnSlab = std::abs(place.x() - gauge.center().x()) < handleReach &&
                        depth > sight.clip.slab->nearest && depth < sight.clip.slab->farthest;
  return isOnSlab ? std::optional(Handle{Part::slab, 0}) : std::nullopt;
}

bool ClipHandles::hover(std::optional<Handle> handle) {
  return std::exchange(hovered_, handle) != handle;
}

bool ClipHandles::press(const Sight& sight, const QPointF& place) {
  const std::optional<Handle> handle = at(sight, place);
  if (!handle) return false;
  hovered_ = handle;
  drag_ = {*handle, sight.clip, heldAt(sight, sight.clip, *handle, place)};
  return true;
}

Clip ClipHandles::drag(const Sight& sight, const QPointF& place) const {
  Clip clip = drag_->before;
  const double by = heldAt(sight, drag_->before, drag_->handle, place) - drag_->pressed;
  if (isFace(drag_->handle.part))
    clip.box = movedBox(*clip.box, sight.bounds, drag_->handle, by);
  else
    clip.slab = movedSlab(*clip.slab, drag_->handle.part, by);
  return clip;
}

Clip ClipHandles::cancel() {
  Clip before = drag_->before;
  drag_.reset();
  return before;
}

void ClipHandles::paintBox(QPainter& painter, const Sight& sight, const QColor& color) {
  const Eigen::AlignedBox3d& box = *sight.clip.box;
  painter.setPen(QPen(color, 1.2));
  for (unsigned corner = 0; corner < 8; ++corner)
    for (unsigned axis = 1; axis < 8; axis *= 2) {
      if ((corner & axis) != 0) continue;
      using OfBox = Eigen::AlignedBox3d::CornerType;
      const auto from = pixelOf(sight.screen, box.corner(OfBox(corner)));
      const auto to = pixelOf(sight.screen, box.corner(OfBox(corner | axis)));
      if (from && to) painter.drawLine(*from, *to);
    }
}

void ClipHandles::paintGauge(QPainter& painter, const Sight& sight, bool dark) const {
  const Palette colors = palette(dark);
  const QRectF gauge = gaugeOf(sight.screen);
  const double front = placeOn(gauge, sight.clip.slab->nearest);
  const double back = placeOn(gauge, sight.clip.slab->farthest);
  paintVeil(painter, gauge.adjusted(-14, -30, 14, 30), colors.backgroundTop);
  painter.setPen(Qt::NoPen);
  painter.setBrush(toQt(colors.text, 60));
  painter.drawRoundedRect(gauge, 4, 4);
  painter.setBrush(toQt(colors.contracted, hovered_ && hovered_->part == Part::slab ? 255 : 170));
  painter.drawRoundedRect(QRectF(gauge.left(), back, gauge.width(), front - back), 4, 4);
  const auto write = [&](double place, const char* text) {
    drawText(painter, QRectF(gauge.center().x() - 40, place - 10, 80, 20), Qt::AlignCenter,
             QCoreApplication::translate("espalier::ClipHandles", text), colors);
  };
  write(gauge.top() - 18, QT_TRANSLATE_NOOP("espalier::ClipHandles", "Back"));
  write(gauge.bottom() + 18, QT_TRANSLATE_NOOP("espalier::ClipHandles", "Front"));
}

void ClipHandles::paint(QPainter& painter, const Sight& sight, bool dark) const {
  if (!isShown_) return;
  const Palette colors = palette(dark);
  if (sight.clip.box) paintBox(painter, sight, toQt(colors.contracted, 150));
  if (sight.clip.slab) paintGauge(painter, sight, dark);
  for (const Grip& grip : grips(sight)) {
    const bool isLit = (drag_ ? drag_->handle : hovered_) == grip.handle;
    const QPointF across(-grip.direction.y(), grip.direction.x());
    painter.setPen(QPen(toQt(colors.outline), 1.5));
    painter.setBrush(toQt(isLit ? colors.hovered : colors.contracted));
    if (isFace(grip.handle.part)) { // an arrow head beside the disc: where it goes
      const QPointF tip = grip.place + 22 * grip.direction;
      const QPointF foot = grip.place + 10 * grip.direction;
      painter.drawPolygon(QPolygonF({tip, foot + 7 * across, foot - 7 * across}));
      painter.drawEllipse(grip.place, 6.5, 6.5);
    } else {
      painter.drawRoundedRect(QRectF(grip.place - QPointF(10, 4), QSizeF(20, 8)), 4, 4);
    }
  }
}

} // namespace espalier
