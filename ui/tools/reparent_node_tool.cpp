#include "ui/tools/reparent_node_tool.h"

#include "core/base/error.h"
#include "core/skeleton/edits.h"
#include "ui/document/length_unit.h"
#include "ui/tools/node_edits.h"
#include "ui/tools/screen_plane.h"

#include <algorithm>
#include <utility>

namespace espalier {

QString ReparentNodeTool::hint() const {
  if (moving_.empty()) return tr("Drag a node onto its new parent, or click one after the other");
  const QString names = nodeNames(moving_);
  if (isDragging_ && under().node && !isMoving(under()))
    return tr("Release: attach %1 to %2   Esc: put it back").arg(names, nodeName(*under().node));
  if (isDragging_ && under().edge && !isMoving(under()))
    return tr("Release: attach %1 here on the edge   Esc: put it back").arg(names);
  if (isDragging_) return tr("Drop %1 on its new parent   Esc: put it back").arg(names);
  if (under().node && !isMoving(under()))
    return tr("Click: attach %1 to %2   Esc: leave it").arg(names, nodeName(*under().node));
  if (under().edge && !isMoving(under()))
    return tr("Click: attach %1 here on the edge   Esc: leave it").arg(names);
  return tr("Click the new parent of %1   Drag: turn   Esc: leave it").arg(names);
}

void ReparentNodeTool::cancel() {
  end();
}

void ReparentNodeTool::startWith(const std::vector<NodeId>& nodes) {
  endsWhenDone_ = true;
  take(nodes);
}

bool ReparentNodeTool::act(const ToolInput& input) {
  std::erase_if(moving_, [&](NodeId id) { return !document().skeleton().contains(id); }); // undone
  switch (input.phase) {
  case ToolInput::Phase::press:
    return press(input);
  case ToolInput::Phase::hover:
    preview(input);
    return false;
  case ToolInput::Phase::drag:
    if (!pressed_) return false;
    isDragging_ = isDragging_ || isDragged(*pressed_, input.screen);
    if (isDragging_) preview(input);
    return true;
  case ToolInput::Phase::release:
    return release(input);
  default:
    return false;
  }
}

bool ReparentNodeTool::press(const ToolInput& input) {
  pressed_.reset();
  isDragging_ = false;
  if (input.button != Qt::LeftButton || input.modifiers.testFlag(Qt::ControlModifier)) return false;
  const bool isTarget = !moving_.empty() && !isMoving(input.pick);
  if (isTarget && (input.pick.node || input.pick.edge)) {
    attachTo(input.pick);
    return true;
  }
  if (!input.pick.node) return false;
  if (moving_.empty()) take({*input.pick.node});
  pressed_ = input.screen;
  return true;
}

bool ReparentNodeTool::release(const ToolInput& input) {
  if (!pressed_) return false;
  pressed_.reset();
  if (!std::exchange(isDragging_, false)) return true; // a click: the next one is on the parent
  if (isMoving(input.pick) || (!input.pick.node && !input.pick.edge))
    end(); // dropped on nothing
  else
    attachTo(input.pick);
  return true;
}

void ReparentNodeTool::take(const std::vector<NodeId>& nodes) {
  moving_ = nodes;
  document().selection().set(nodes);
  canvas().showPreview({.lines = {}, .nodes = {}, .label = {}, .subjects = subjects()});
  emit hintChanged();
}

void ReparentNodeTool::attachTo(const Pick& target) {
  const Skeleton& skeleton = document().skeleton();
  const auto carries = [&](NodeId id) { return skeleton.isAncestor(id, target.edge->child); };
  if (target.edge && std::ranges::any_of(moving_, carries))
    throw Error(
        tr("a branch cannot be attached to itself: choose a place outside it").toStdString());
  const QString names = nodeNames(moving_);
  const QString text =
      target.node ? tr("Reparent %1 to %2").arg(names).arg(indexOf(*target.node))
                  : tr("Reparent %1 to the edge of %2").arg(names, nodeName(target.edge->child));
  document().edit(text, [&](SkeletonEditor& editor) {
    const NodeId parent =
        target.node ? *target.node : splitEdge(editor, target.edge->child, target.edge->fraction);
    for (const NodeId id : moving_)
      reparentNode(editor, id, parent);
  });
  end();
}

bool ReparentNodeTool::isMoving(const Pick& pick) const {
  return pick.node && std::ranges::find(moving_, *pick.node) != moving_.end();
}

std::vector<Eigen::Vector3d> ReparentNodeTool::subjects() const {
  std::vector<Eigen::Vector3d> places;
  for (const NodeId id : moving_)
    places.push_back(document().skeleton()[id].position);
  return places;
}

void ReparentNodeTool::preview(const ToolInput& input) {
  Preview shown{.lines = {}, .nodes = {}, .label = {}, .subjects = subjects()};
  double longest = 0; // edge that it would make [L]
  for (const NodeId id : moving_) {
    const Eigen::Vector3d from = document().skeleton()[id].position;
    std::optional<Eigen::Vector3d> to;
    if (input.pick.node)
      to = document().skeleton()[*input.pick.node].position;
    else if (input.pick.edge)
      to = input.pick.edge->position;
    else if (isDragging_)
      to = meet(screenPlane(from, input), input);
    if (!to || isMoving(input.pick)) continue;
    shown.lines.push_back({from, *to}); // the length is written where the pointer is
    longest = std::max(longest, (*to - from).norm());
  }
  if (!shown.lines.empty()) shown.label = formatLength(longest, document().unit());
  canvas().showPreview(shown);
}

void ReparentNodeTool::end() {
  moving_.clear();
  pressed_.reset();
  isDragging_ = false;
  canvas().showPreview({});
  if (std::exchange(endsWhenDone_, false)) emit finished();
}

} // namespace espalier
