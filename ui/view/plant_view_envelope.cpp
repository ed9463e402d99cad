#include "ui/view/plant_view_parts.h"

#include <QMouseEvent>

#include <utility>

namespace espalier {

void PlantView::setEnvelope(std::optional<ShownEnvelope> envelope) {
  if (!envelope && !parts_->shared->envelope) return;
  const std::size_t before =
      parts_->shared->envelope ? parts_->shared->envelope->handles.size() : 0;
  const bool areOthers = before != (envelope ? envelope->handles.size() : 0);
  parts_->shared->envelope = std::move(envelope);
  for (Parts* each : parts_->shared->views) {
    if (areOthers) { // what was held is no more
      each->envelopeHandles.release();
      each->hoverEnvelope(std::nullopt);
    }
    each->overlayWidget->update();
  }
}

void PlantView::Parts::hoverEnvelope(std::optional<std::size_t> handle) {
  if (!envelopeHandles.hover(handle)) return;
  if (!handle)
    owner.unsetCursor();
  else
    owner.setCursor(Qt::PointingHandCursor);
  if (handle) pointer.leave(); // it is no longer over the plant
  emit shared->views.front()->owner.envelopeHovered(handle);
  overlayWidget->update();
}

void PlantView::Parts::giveBackEnvelope() {
  if (!envelopeHandles.dragged()) return;
  envelopeHandles.release();
  overlayWidget->update();
  emit shared->views.front()->owner.envelopeGivenBack();
}

bool PlantView::pressEnvelope(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton || event.modifiers() != Qt::NoModifier) return false;
  if (!parts_->shared->envelope || parts_->pointer.isBusy()) return false;
  if (!parts_->envelopeHandles.press(parts_->shared->envelope->handles, parts_->pointer.screen(),
                                     event.position()))
    return false;
  parts_->overlayWidget->update();
  emit parts_->shared->views.front()->owner.envelopePressed();
  return true;
}

bool PlantView::moveEnvelope(const QMouseEvent& event) {
  if (!parts_->shared->envelope) return false;
  const std::vector<ShownHandle>& handles = parts_->shared->envelope->handles;
  if (const auto dragged = parts_->envelopeHandles.dragged()) {
    const Eigen::Vector3d to =
        parts_->envelopeHandles.drag(handles, parts_->pointer.screen(), event.position());
    emit parts_->shared->views.front()->owner.envelopeDragged(*dragged, to);
    return true;
  }
  if (event.buttons() != Qt::NoButton) return false;
  const auto handle = EnvelopeHandles::at(handles, parts_->pointer.screen(), event.position());
  parts_->hoverEnvelope(handle);
  return handle.has_value();
}

bool PlantView::releaseEnvelope(const QMouseEvent& event) {
  if (event.button() != Qt::LeftButton || !parts_->envelopeHandles.dragged()) return false;
  parts_->envelopeHandles.release();
  parts_->overlayWidget->update();
  emit parts_->shared->views.front()->owner.envelopeReleased();
  moveEnvelope(event); // what is under the pointer now
  return true;
}

} // namespace espalier
