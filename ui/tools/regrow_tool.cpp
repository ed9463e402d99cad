#include "ui/tools/regrow_tool.h"

#include "core/base/error.h"
#include "core/skeleton/branch_edits.h"
#include "core/skeleton/select.h"
#include "ui/document/length_unit.h"
#include "ui/tools/node_edits.h"
#include "ui/tools/screen_plane.h"

#include <algorithm>
#include <functional>
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

/// The longest path along the edges from the root to a tip [L].
double lengthOf(const Skeleton& part) {
  std::vector<double> along(part.idEnd(), 0);
  double longest = 0;
  for (const NodeId id : part.ids()) {
    const Node& node = part[id];
    if (!node.parent) continue;
    along[indexOf(id)] =
        along[indexOf(*node.parent)] + (node.position - part[*node.parent].position).norm();
    longest = std::max(longest, along[indexOf(id)]);
  }
  return longest;
}

/// By how many more or fewer are shown at once.
std::size_t fifthOf(std::size_t shown) {
  return std::max<std::size_t>(1, shown / 5);
}

QString newNodes(std::size_t count) {
  return count == 1 ? RegrowTool::tr("1 new node")
                    : RegrowTool::tr("%1 new nodes").arg(formatCount(count));
}

} // namespace

QString RegrowTool::branchesHint() const {
  std::size_t nodes = 0;
  for (std::size_t i = 0; i < shown_; ++i)
    nodes += branches_[i].part.size() - 1;
  const QString added = newNodes(nodes);
  const QString end = tr("Enter accepts, Esc drops");
  if (branches_.size() == 1)
    return tr("%1 on %2   %3").arg(added, nodeName(branches_.front().on), end);
  const QString length = formatLength(lengths_[shown_ - 1], document().unit(), 3);
  return tr("%1 of %2 branches, from %3 on: %4   %5   {fewer_branches} fewer   "
            "{more_branches} more")
      .arg(formatCount(shown_), formatCount(branches_.size()), length, added, end);
}

QString RegrowTool::hint() const {
  if (!branches_.empty()) return branchesHint();
  if (!node_) return tr("Click a node: what it carries is reconstructed again");
  const std::size_t carried = downstream(document().skeleton(), {*node_}).size() - 1;
  return tr("%1 for the %2 that %3 carries   Enter accepts, Esc drops")
      .arg(newNodes(part_.size() - 1), formatCount(carried), nodeName(*node_));
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
  const Skeleton& skeleton = document().skeleton();
  for (std::size_t i = 0; i < shown_; ++i)
    if (const GrownBranch& branch = branches_[i];
        !skeleton.contains(branch.on) || (branch.fraction < 1 && !skeleton[branch.on].parent))
      throw Error(tr("%1 is gone, which was to carry a branch: drop this, and grow it again")
                      .arg(nodeName(branch.on))
                      .toStdString());
  std::vector<NodeId> added;
  document().edit(text_, [&](SkeletonEditor& editor) {
    added = addGrown(editor, {branches_.begin(), branches_.begin() + std::ptrdiff_t(shown_)});
  });
  document().selection().set(downstream(document().skeleton(), added));
  cancel();
}

void RegrowTool::cancel() {
  if (!hasPreview()) return;
  node_.reset();
  part_ = {};
  branches_.clear();
  shown_ = 0;
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
  shown_ = 0;
  Preview preview;
  addTo(preview, part);
  canvas().showPreview(preview);
  emit hintChanged();
}

void RegrowTool::show(std::vector<GrownBranch> branches, const QString& text, double least) {
  node_.reset();
  branches_.clear();
  lengths_.clear();
  text_ = text;
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < branches.size(); ++i)
    order.emplace_back(lengthOf(branches[i].part), i);
  std::ranges::stable_sort(order, std::greater<>(), &std::pair<double, std::size_t>::first);
  for (const auto& [length, i] : order) {
    branches_.push_back(std::move(branches[i]));
    lengths_.push_back(length);
  }
  const auto isLong = [least](double length) { return length >= least; };
  shown_ = std::max<std::size_t>(1, std::size_t(std::ranges::count_if(lengths_, isLong)));
  preview();
}

void RegrowTool::showFewer() {
  if (!canShowFewer()) return;
  shown_ -= fifthOf(shown_);
  preview();
}

void RegrowTool::showMore() {
  if (!canShowMore()) return;
  shown_ = std::min(branches_.size(), shown_ + fifthOf(shown_));
  preview();
}

void RegrowTool::preview() {
  Preview preview;
  for (std::size_t i = 0; i < shown_; ++i)
    addTo(preview, branches_[i].part);
  canvas().showPreview(preview);
  emit hintChanged();
}

bool RegrowTool::act(const ToolInput& input) {
  const auto pressed = pressedOnEdge_;
  if (input.phase != ToolInput::Phase::drag) pressedOnEdge_.reset();
  if (input.phase == ToolInput::Phase::release && pressed && !isDragged(*pressed, input.screen))
    throw Error(tr("click a node: what it carries is reconstructed again").toStdString());
  if (input.phase != ToolInput::Phase::press || input.button != Qt::LeftButton ||
      input.modifiers.testFlag(Qt::ControlModifier))
    return false;
  if (!input.pick.node) {
    if (input.pick.edge) pressedOnEdge_ = input.screen; // a drag from there turns the view
    return false;
  }
  document().selection().set({*input.pick.node});
  emit wanted(*input.pick.node);
  return true;
}

} // namespace espalier
