#include "ui/view/picture.h"
#include "ui/view/plant_view_parts.h"

#include <algorithm>

namespace espalier {

void PlantView::setState(Side side, const std::optional<PlantState>& state) {
  parts_->scene.setOther(side, state);
  for (Parts* view : parts_->shared->views)
    view->unsettle(Parts::besidePreviews); // while a knob is turned the next one comes soon
  QTimer::singleShot(0, this, [this] { parts_->redraw(); }); // what the user does comes first
}

void PlantView::setDivider(double across) {
  if (across == parts_->divider) return;
  parts_->divider = std::clamp(across, 0.0, 1.0);
  parts_->redrawThis();
  if (!parts_->isFirst()) parts_->shared->views.front()->redrawThis(); // its legends
}

double PlantView::divider() const {
  return parts_->divider;
}

void PlantView::setBlend(std::optional<double> blend) {
  parts_->scene.blend = blend;
  parts_->redraw();
}

void PlantView::setDisplacementsShown(bool areShown) {
  parts_->scene.displacementsShown = areShown;
  parts_->redraw();
}

void PlantView::showSight(const std::optional<ShownSight>& sight) {
  if (!sight && !parts_->overlay.sight) return;
  for (Parts* view : parts_->shared->views) {
    view->overlay.sight = sight;
    view->overlayWidget->update();
  }
}

const std::optional<ShownSight>& PlantView::sightShown() const {
  return parts_->overlay.sight;
}

SeenSides PlantView::Shared::seenSides() const {
  SeenSides seen{.left = false, .right = false};
  for (const Parts* view : views) {
    seen.left = seen.left || view->divider > 0;
    seen.right = seen.right || view->divider < 1;
  }
  return seen;
}

QImage PlantView::pictureOf(const PlantState& state, const QSize& size, Framing framing) const {
  Scene scene = parts_->scene;
  scene.setFocus(std::nullopt);
  if (framing == Framing::whole) scene.setSeenRange(std::nullopt);
  scene.setOther(Side::left, state);
  return parts_->bare(scene, size, framing);
}

QImage PlantView::paperOf(const PlantState& state, const QSize& size, Framing framing) const {
  Scene scene;
  scene.pointColor = PointColor::uniform;
  scene.setCloud(parts_->scene.cloud);
  scene.contracted.set(state.contracted); // all of them: the points are not drawn
  scene.points.visible = state.contracted == nullptr;
  scene.setSkeleton(state.skeleton);
  scene.clip = parts_->scene.clip;
  return parts_->bare(scene, size, framing);
}

QImage PlantView::Parts::bare(const Scene& other, const QSize& size, Framing framing) const {
  Camera camera = navigator.destination();
  if (framing == Framing::whole)
    camera.frame(other.outline(), size.width() / double(size.height()));
  Overlay bare;
  bare.isBare = true;
  return espalier::picture(other, camera, bare, size);
}

void PlantView::Parts::refreshDivider() {
  const bool isDivided =
      divider > 0 && divider < 1 && std::ranges::any_of(scene.others, &OtherState::isShown);
  if (!isDivided) {
    if (dividerHandle != nullptr) dividerHandle->hide();
    return;
  }
  if (dividerHandle == nullptr) {
    dividerHandle = new Divider(&owner);
    connect(dividerHandle, &Divider::entered, &owner, [this] { pointer.leave(); });
    connect(dividerHandle, &Divider::moveAsked, &owner, [this](double across) {
      owner.setDivider(across);
      emit owner.dividerMoved(across);
    });
  }
  dividerHandle->place(divider, scene.dark);
  dividerHandle->show();
}

} // namespace espalier
