#include "ui/tools/regrow_tool.h"

#include "core/base/error.h"
#include "core/skeleton/branch_edits.h"
#include "core/skeleton/select.h"
#include "ui/document/length_unit.h"
#include "ui/tools/node_edits.h"

namespace espalier {

QString RegrowTool::hint() const {
  if (!node_) return tr("Click a node: what it carries is reconstructed again");
  const std::size_t carried = downstream(document().skeleton(), {*node_}).size() - 1;
  return tr("%1 new nodes for the %2 that %3 carries   Enter accepts, Esc drops")
      .arg(part_.size() - 1)
      .arg(carried)
      .arg(nodeName(*node_));
}

void RegrowTool::accept() {
  const NodeId node = *node_;
  if (!document().skeleton().contains(node))
    throw Error(tr("the node is gone: choose another one").toStdString());
  document().edit(tr("Regrow %1").arg(nodeName(node)),
                  [&](SkeletonEditor& editor) { replaceCarried(editor, node, part_); });
  document().selection().set({node});
  cancel();
}

void RegrowTool::cancel() {
  if (!node_) return;
  node_.reset();
  part_ = {};
  canvas().showPreview({});
  emit finished();
}

void RegrowTool::startWith(const std::vector<NodeId>& nodes) {
  if (nodes.size() > 1) throw Error(tr("one node is regrown at a time: select one").toStdString());
  emit wanted(nodes.front());
}

void RegrowTool::show(NodeId node, const Skeleton& part) {
  node_ = node;
  part_ = part;
  Preview preview;
  for (const NodeId id : part.ids()) {
    const Node& each = part[id];
    if (!each.parent) continue;
    preview.lines.push_back({part[*each.parent].position, each.position});
    preview.nodes.push_back(each.position);
  }
  canvas().showPreview(preview);
  emit hintChanged();
}

bool RegrowTool::act(const ToolInput& input) {
  if (input.phase != ToolInput::Phase::press || input.button != Qt::LeftButton ||
      input.modifiers.testFlag(Qt::ControlModifier) || !input.pick.node)
    return false;
  document().selection().set({*input.pick.node});
  emit wanted(*input.pick.node);
  return true;
}

} // namespace espalier
