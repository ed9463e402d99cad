#include "ui/view/plant_view_parts.h"

#include <QMouseEvent>

#include <algorithm>

namespace espalier {

void PlantView::setClip(const Clip& clip) {
  if (clip == parts_->scene.clip) return;
  parts_->scene.clip = clip;
  parts_->redraw();
  if (!parts_->clipHandles.isDragging()) hoverAgain();
  emit parts_->shared->views.front()->owner.clipChanged();
}

const Clip& PlantView::clip() const {
  return parts_->scene.clip;
}

void PlantView::setDepthFade(double strength) {
  const double fade = std::clamp(strength, 0.0, 1.0);
  if (fade == parts_->scene.depthFade) return;
  parts_->scene.depthFade = fade;
  parts_->redraw();
  emit parts_->shared->views.front()->owner.clipChanged();
}

double PlantView::depthFade() const {
  return parts_->scene.depthFade;
}

void PlantView::setFocusFade(double strength) {
  const double fade = std::clamp(strength, 0.0, 1.0);
  if (fade == parts_->scene.focusFade) return;
  parts_->scene.focusFade = fade;
  parts_->redraw();
  emit parts_->shared->views.front()->owner.clipChanged();
}

double PlantView::focusFade() const {
  return parts_->scene.focusFade;
}

void PlantView::focusOff() {
  if (!parts_->scene.focus) return;
  parts_->scene.setFocus(std::nullopt);
  parts_->redraw();
}

void PlantView::setClipHandlesShown(bool areShown) {
  for (Parts* view : parts_->shared->views) {
    if (view->clipHandles.isDragging() && !areShown) setClip(view->clipHandles.cancel());
    view->clipHandles.setShown(areShown);
    view->hoverClip(std::nullopt);
  }
  parts_->redraw();
}

void PlantView::Parts::hoverClip(std::optional<ClipHandles::Handle> handle) {
  if (!clipHandles.hover(handle)) return;
  if (!handle)
    owner.unsetCursor();
  else
    owner.setCursor(Qt::PointingHandCursor);
  if (handle) pointer.leave(); // it is no longer over the plant
  overlayWidget->update();
}

bool PlantView::pressClip(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton || event.modifiers() != Qt::NoModifier) return false;
  if (parts_->pointer.isBusy() || !parts_->clipHandles.press(parts_->sight(), event.position()))
    return false;
  parts_->overlayWidget->update();
  return true;
}

bool PlantView::moveClip(const QMouseEvent& event) {
  if (parts_->clipHandles.isDragging()) {
    setClip(parts_->clipHandles.drag(parts_->sight(), event.position()));
    return true;
  }
  if (event.buttons() != Qt::NoButton) return false;
  const auto handle = parts_->clipHandles.at(parts_->sight(), event.position());
  parts_->hoverClip(handle);
  return handle.has_value();
}

bool PlantView::releaseClip(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton || !parts_->clipHandles.isDragging()) return false;
  parts_->clipHandles.release();
  parts_->overlayWidget->update();
  moveClip(event); // what is under the pointer now
  return true;
}

} // namespace espalier
