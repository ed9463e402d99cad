#include "ui/tools/reparent_node_tool.h"

#include "core/skeleton/edits.h"
#include "ui/tools/node_edits.h"

namespace espalier {

QString ReparentNodeTool::hint() const {
  if (moving_.empty()) return tr("Click the node that hangs in the wrong place");
  if (under().node)
    return tr("Click: hang %1 on %2   Esc: leave it")
        .arg(nodeNames(moving_), nodeName(*under().node));
  return tr("Click the new parent of %1   Drag: turn   Esc: leave it").arg(nodeNames(moving_));
}

void ReparentNodeTool::cancel() {
  moving_.clear();
  emit finished();
}

void ReparentNodeTool::startWith(const std::vector<NodeId>& nodes) {
  moving_ = nodes;
  document().selection().set(nodes);
  emit hintChanged();
}

bool ReparentNodeTool::act(const ToolInput& input) {
  const bool turnsView = input.modifiers.testFlag(Qt::ControlModifier);
  if (input.phase != ToolInput::Phase::press || input.button != Qt::LeftButton || turnsView ||
      !input.pick.node)
    return false;
  std::erase_if(moving_, [&](NodeId id) { return !document().skeleton().contains(id); }); // undone
  if (moving_.empty())
    startWith({*input.pick.node});
  else
    hangOn(*input.pick.node);
  return true;
}

void ReparentNodeTool::hangOn(NodeId parent) {
  document().edit(tr("Reparent %1 to %2").arg(nodeNames(moving_)).arg(indexOf(parent)),
                  [&](SkeletonEditor& editor) {
                    for (const NodeId id : moving_)
                      reparentNode(editor, id, parent);
                  });
  moving_.clear();
  emit finished();
}

} // namespace espalier
