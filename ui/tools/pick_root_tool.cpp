#include "ui/tools/pick_root_tool.h"

#include "core/base/error.h"
#include "ui/tools/screen_plane.h"

#include <utility>

namespace espalier {

QString PickRootTool::hint() const {
  return tr("Click the foot of the trunk: the plant will be rooted there   Drag: turn   "
            "{root_lowest} lowest point   Esc: leave");
}

void PickRootTool::cancel() {
  press_.reset();
  leave();
}

void PickRootTool::leave() {
  if (std::exchange(isShown_, false)) canvas().showPreview({});
}

bool PickRootTool::act(const ToolInput& input) {
  switch (input.phase) {
  case ToolInput::Phase::hover: {
    Preview preview;
    if (const auto place = placeOf(input.pick))
      preview = {.lines = {}, .nodes = {*place}, .label = tr("root here")};
    isShown_ = !preview.isEmpty();
    canvas().showPreview(preview);
    return false;
  }
  case ToolInput::Phase::press:
    press_.reset();
    if (input.button == Qt::LeftButton && !input.modifiers.testFlag(Qt::ControlModifier))
      press_ = input.screen;
    return false; // a drag is the camera's
  case ToolInput::Phase::drag:
    if (press_ && isDragged(*press_, input.screen)) press_.reset();
    return false;
  case ToolInput::Phase::release:
    if (std::exchange(press_, {})) click(input.pick);
    return false;
  default:
    return false;
  }
}

void PickRootTool::click(const Pick& pick) {
  if (document().scan() == nullptr)
    throw Error(tr("there is no scan to choose the root in: open one first").toStdString());
  const std::optional<Eigen::Vector3d> place = placeOf(pick);
  if (!place) throw Error(tr("click a point of the scan, at the foot of the trunk").toStdString());
  cancel();
  document().setRoot(place);
  emit finished();
}

/// Of what is drawn contracted, or of a node, the nearest point of the scan is meant.
std::optional<Eigen::Vector3d> PickRootTool::placeOf(const Pick& pick) const {
  const Scan* scan = document().scan();
  std::optional<Eigen::Vector3d> at = pick.point;
  if (pick.edge) at = pick.edge->position;
  if (pick.node) at = document().skeleton()[*pick.node].position;
  if (!at || scan == nullptr) return std::nullopt;
  const PointCloud& cloud = *scan->cloud();
  const auto nearest = scan->index().nearestOne((*at - cloud.origin()).cast<float>());
  if (!nearest) return std::nullopt;
  return cloud.position(nearest->index);
}

} // namespace espalier
