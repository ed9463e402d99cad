#include "ui/tools/add_node_tool.h"

#include "core/base/error.h"
#include "core/skeleton/edits.h"
#include "ui/tools/node_edits.h"
#include "ui/tools/screen_plane.h"

namespace espalier {

QString AddNodeTool::hint() const {
  if (pull_ && pull_->isCanceled) return tr("Taken back. Release the button");
  if (pull_ && pull_->node) return tr("Release: leave it here   Esc: take it back");
  if (under().node)
    return tr("Drag: pull a child out of %1   Click: go on from it").arg(nodeName(*under().node));
  if (under().edge) return tr("Press: insert a node here   Drag: move it");
  const std::optional<NodeId> current = document().selection().current();
  if (document().skeleton().isEmpty()) return tr("Click a point: put the root there");
  if (under().point && current)
    return tr("Click: add a child of %1 here   Drag: turn").arg(nodeName(*current));
  if (current) return tr("Click a point: add a child of %1   Drag: turn").arg(nodeName(*current));
  return tr("Click a node: go on from it   Drag a node: pull a child   Press an edge: insert");
}

void AddNodeTool::cancel() {
  if (!pull_) return;
  document().cancel(pull_->gesture);
  pull_->isCanceled = true;
}

bool AddNodeTool::act(const ToolInput& input) {
  switch (input.phase) {
  case ToolInput::Phase::press:
    return press(input);
  case ToolInput::Phase::drag:
    if (camera_ && isDragged(*camera_, input.screen)) camera_.reset();
    if (!pull_) return false;
    drag(input);
    return true;
  case ToolInput::Phase::release: {
    const bool wasMine = pull_.has_value();
    if (!wasMine && camera_ && !isDragged(*camera_, input.screen)) clickPoint(input);
    pull_.reset();
    camera_.reset();
    return wasMine;
  }
  case ToolInput::Phase::hover: // a release elsewhere is not sent, as after a change of windows
    if (pull_ && pull_->isCanceled) pull_.reset();
    return false;
  default:
    return false;
  }
}

bool AddNodeTool::press(const ToolInput& input) {
  pull_.reset();
  camera_.reset();
  if (input.button != Qt::LeftButton || input.modifiers.testFlag(Qt::ControlModifier)) return false;
  if (input.pick.node) {
    const NodeId parent = *input.pick.node;
    document().selection().set({parent});
    pull_ = Pull{.parent = parent,
                 .node = {},
                 .plane = screenPlane(document().skeleton()[parent].position, input),
                 .gesture = Gesture::begin(),
                 .screen = input.screen};
    return true;
  }
  if (input.pick.edge) {
    const EdgePick& edge = *input.pick.edge;
    pull_ = Pull{.parent = {},
                 .node = {},
                 .plane = screenPlane(edge.position, input),
                 .gesture = Gesture::begin(),
                 .screen = input.screen};
    document().edit(
        tr("Insert a node below %1").arg(nodeName(edge.child)),
        [&](SkeletonEditor& editor) { pull_->node = splitEdge(editor, edge.child, edge.fraction); },
        pull_->gesture);
    document().selection().set({*pull_->node});
    return true;
  }
  camera_ = input.screen;
  return false;
}

void AddNodeTool::drag(const ToolInput& input) {
  const std::optional<Eigen::Vector3d> at = meet(pull_->plane, input);
  if (pull_->isCanceled || !at) return;
  if (pull_->node) {
    document().edit(
        tr("Move %1").arg(nodeName(*pull_->node)),
        [&](SkeletonEditor& editor) { moveNode(editor, *pull_->node, *at); }, pull_->gesture);
    return;
  }
  if (!isDragged(pull_->screen, input.screen)) return;
  document().edit(
      tr("Add a child to %1").arg(nodeName(*pull_->parent)),
      [&](SkeletonEditor& editor) { pull_->node = addChild(editor, *pull_->parent, *at); },
      pull_->gesture);
  document().selection().set({*pull_->node});
}

void AddNodeTool::clickPoint(const ToolInput& input) {
  if (!input.pick.point || !document().scan()) return;
  const Eigen::Vector3d place = document().scan()->onPoints(*input.pick.point);
  const std::optional<NodeId> parent = document().selection().current();
  if (!parent && !document().skeleton().isEmpty())
    throw Error(tr("no node to go on from: click one first").toStdString());
  NodeId added{};
  document().edit(parent ? tr("Add a child to %1").arg(nodeName(*parent)) : tr("Add a root"),
                  [&](SkeletonEditor& editor) {
                    added =
                        parent ? addChild(editor, *parent, place) : editor.add({.position = place});
                  });
  document().selection().set({added});
}

} // namespace espalier
