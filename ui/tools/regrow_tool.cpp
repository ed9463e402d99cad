#include "ui/tools/regrow_tool.h"

#include "core/base/error.h"
#include "core/skeleton/branch_edits.h"
#include "core/skeleton/select.h"
#include "ui/document/length_unit.h"
#include "ui/tools/node_edits.h"

#include <utility>

namespace espalier {
namespace {

void addTo(Preview& preview, const Skeleton& part) {
  for (const NodeId id : part.ids()) {
    const Node& each = part[id];
    if (!each.parent) continue;
    preview.lines.push_back({part[*each.parent].position, each.position});
    preview.nodes.push_back(each.position);
  }
}

} // namespace

QString RegrowTool::hint() const {
  if (!branches_.empty()) {
    std::size_t nodes = 0;
    for (const GrownBranch& branch : branches_)
      nodes += branch.part.size() - 1;
    return tr("%1 new nodes on %2   Enter accepts, Esc drops")
        .arg(formatCount(nodes), branches_.size() == 1
                                     ? nodeName(branches_.front().on)
                                     : tr("%1 nodes").arg(formatCount(branches_.size())));
  }
  if (!node_) return tr("Click a node: what it carries is reconstructed again");
  const std::size_t carried = downstream(document().skeleton(), {*node_}).size() - 1;
  return tr("%1 new nodes for the %2 that %3 carries   Enter accepts, Esc drops")
      .arg(part_.size() - 1)
      .arg(carried)
      .arg(nodeName(*node_));
}

void RegrowTool::accept() {
  if (!branches_.empty()) return acceptBranches();
  const NodeId node = *node_;
  if (!document().skeleton().contains(node))
    throw Error(tr("the node is gone: choose another one").toStdString());
  document().edit(tr("Regrow %1").arg(nodeName(node)),
                  [&](SkeletonEditor& editor) { replaceCarried(editor, node, part_); });
  document().selection().set({node});
  cancel();
}

void RegrowTool::acceptBranches() {
  for (const GrownBranch& branch : branches_)
    if (!document().skeleton().contains(branch.on))
      throw Error(tr("%1 is gone, which was to carry a branch: drop this, and grow it again")
                      .arg(nodeName(branch.on))
                      .toStdString());
  std::vector<NodeId> added;
  document().edit(text_, [&](SkeletonEditor& editor) {
    for (const GrownBranch& branch : branches_)
      for (const NodeId first : addCarried(editor, branch.on, branch.part))
        added.push_back(first);
  });
  document().selection().set(downstream(document().skeleton(), added));
  cancel();
}

void RegrowTool::cancel() {
  if (!hasPreview()) return;
  node_.reset();
  part_ = {};
  branches_.clear();
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
  branches_.clear();
  Preview preview;
  addTo(preview, part);
  canvas().showPreview(preview);
  emit hintChanged();
}

void RegrowTool::show(std::vector<GrownBranch> branches, const QString& text) {
  node_.reset();
  branches_ = std::move(branches);
  text_ = text;
  Preview preview;
  for (const GrownBranch& branch : branches_)
    addTo(preview, branch.part);
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
