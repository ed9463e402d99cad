#include "ui/tools/thing_gesture.h"

#include "core/base/error.h"
#include "ui/tools/screen_plane.h"

#include <utility>

namespace espalier {

using Thing = PointQuestion::Thing;

void ThingGesture::begin(Thing thing) {
  cancel();
  question_.thing = thing;
}

QString ThingGesture::hint() const {
  switch (question_.thing) {
  case Thing::pole:
    return tr("Click a pole: selects its points");
  case Thing::wire:
    return isBegun() ? tr("Click the wire at its other end   Esc: leave it")
                     : tr("Click a wire at one end, then at the other: selects its points");
  case Thing::plant:
    return tr("Click a plant: selects its points");
  }
  return {};
}

std::size_t ThingGesture::clicks() const {
  return question_.thing == Thing::wire ? 2 : 1;
}

void ThingGesture::hover(const ToolInput& input) {
  press_.reset();
  show(input.pick.pointOfThing);
}

void ThingGesture::press(const ToolInput& input) {
  press_ = input.screen;
}

void ThingGesture::drag(const ToolInput& input) {
  if (press_ && isDragged(*press_, input.screen)) press_.reset();
}

std::optional<PointQuestion> ThingGesture::release(const ToolInput& input) {
  if (!std::exchange(press_, std::nullopt)) return std::nullopt;
  if (!input.pick.pointOfThing)
    throw Error(tr("there is no point here: click one of the thing to select").toStdString());
  question_.places.push_back(*input.pick.pointOfThing);
  if (question_.places.size() < clicks()) {
    show(std::nullopt);
    return std::nullopt;
  }
  const PointQuestion asked = question_;
  cancel();
  return asked;
}

void ThingGesture::cancel() {
  question_.places.clear();
  press_.reset();
  show(std::nullopt);
}

void ThingGesture::show(const std::optional<Eigen::Vector3d>& next) {
  Preview preview;
  preview.nodes = question_.places;
  if (next) preview.nodes.push_back(*next);
  if (preview.nodes.size() > 1) preview.lines = {preview.nodes};
  if (preview.isEmpty() && !isShown_) return; // what is shown is another tool's
  isShown_ = !preview.isEmpty();
  canvas_.showPreview(preview);
}

} // namespace espalier
