#include "ui/tools/area_gesture.h"

#include "ui/tools/screen_plane.h"

#include <QRectF>

#include <utility>

namespace espalier {

std::optional<AreaGesture::Shape> AreaGesture::shapeOf(const ToolInput& press) {
  if (press.button != Qt::LeftButton) return std::nullopt;
  if (press.modifiers.testFlag(Qt::AltModifier)) return Shape::lasso;
  if (press.modifiers.testFlag(Qt::ShiftModifier)) return Shape::box;
  return std::nullopt;
}

void AreaGesture::begin(Shape shape, const ToolInput& press) {
  shape_ = shape;
  pointerPath_ = QPolygonF({press.screen});
  area_.clear();
  hasMoved_ = isCanceled_ = false;
}

void AreaGesture::drag(const ToolInput& input) {
  if (!shape_ || isCanceled_) return;
  hasMoved_ = hasMoved_ || isDragged(pointerPath_.first(), input.screen);
  if (!hasMoved_) return;
  if (pointerPath_.last() != input.screen) pointerPath_.append(input.screen);
  if (*shape_ == Shape::box) {
    area_ = QPolygonF(QRectF(pointerPath_.first(), input.screen).normalized());
  } else {
    area_ = pointerPath_;
    area_.append(pointerPath_.first());
  }
  canvas_.showBand(area_);
}

std::optional<QPolygonF> AreaGesture::end() {
  const bool isDrawn = shape_ && hasMoved_ && !isCanceled_;
  shape_.reset();
  hasMoved_ = isCanceled_ = false;
  canvas_.showBand({});
  if (!isDrawn) return std::nullopt;
  return std::exchange(area_, {});
}

void AreaGesture::cancel() {
  if (!shape_) return;
  isCanceled_ = true;
  canvas_.showBand({});
}

} // namespace espalier
