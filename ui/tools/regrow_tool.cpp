#include "ui/tools/regrow_tool.h"

#include "core/base/error.h"
#include "core/skeleton/axes.h"
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

QString nodesText(std::size_t count) {
  return count == 1 ? RegrowTool::tr("1 new node")
                    : RegrowTool::tr("%1 new nodes").arg(formatCount(count));
}

std::vector<Eigen::Vector3d> placesOf(const Skeleton& part) {
  std::vector<Eigen::Vector3d> places;
  for (const NodeId id : part.ids())
    places.push_back(part[id].position);
  return places;
}

} // namespace

QString RegrowTool::walkHint() const {
  const std::optional<std::size_t> at = current();
  if (!at) return tr("Enter accepts, Esc drops");
  return tr("%1: %2 long   {take_branch} takes   {drop_branch} drops   Enter: all   "
            "Esc: none")
      .arg(formatCount(*at + 1), formatLength(proposals_[*at].length, document().unit(), 3));
}

QString RegrowTool::branchesHint() const {
  const QString added = nodesText(newNodes());
  if (branches_.size() == 1)
    return tr("%1 on %2   %3").arg(added, nodeName(branches_.front().on), walkHint());
  const QString length = formatLength(proposals_[shown_ - 1].length, document().unit(), 3);
  return tr("%1 of %2 branches, from %3 on: %4   %5   {fewer_branches} fewer   "
            "{more_branches} more")
      .arg(formatCount(shown_), formatCount(branches_.size()), length, added, walkHint());
}

QString RegrowTool::hint() const {
  if (!branches_.empty()) return branchesHint();
  if (!node_) return tr("Click a node: what it carries is reconstructed again");
  return tr("%1 for the %2 that %3 carries   %4")
      .arg(nodesText(newNodes()), formatCount(carried_), nodeName(*node_), walkHint());
}

std::optional<std::size_t> RegrowTool::current() const {
  if (shown() < 2) return std::nullopt;
  for (std::size_t i = 0; i < shown(); ++i)
    if (!proposals_[i].isTaken && !proposals_[i].isDropped) return i;
  return std::nullopt;
}

std::size_t RegrowTool::newNodes() const {
  std::size_t nodes = 0;
  for (std::size_t i = 0; i < shown(); ++i)
    if (!proposals_[i].isDropped) nodes += proposals_[i].look.nodes.size();
  return nodes;
}

void RegrowTool::takeCurrent() {
  const std::optional<std::size_t> at = current();
  if (!at) return;
  proposals_[*at].isTaken = true;
  goOn();
}

void RegrowTool::dropCurrent() {
  const std::optional<std::size_t> at = current();
  if (!at) return;
  proposals_[*at].isDropped = true;
  for (Proposal& each : proposals_) // each comes after the one that carries it
    if (each.on && proposals_[*each.on].isDropped) each.isDropped = true;
  goOn();
}

void RegrowTool::goOn() {
  if (const std::optional<std::size_t> at = current()) {
    preview();
    emit reached(proposals_[*at].places);
    return;
  }
  const auto isTaken = [](const Proposal& each) { return each.isTaken; };
  if (std::ranges::any_of(proposals_, isTaken))
    accept();
  else
    cancel();
}

void RegrowTool::accept() {
  if (branches_.empty())
    acceptPart();
  else
    acceptBranches();
}

void RegrowTool::acceptPart() {
  const NodeId node = *node_;
  if (!document().skeleton().contains(node))
    throw Error(tr("the node is gone: choose another one").toStdString());
  Skeleton part = part_;
  for (auto each = proposals_.rbegin(); each != proposals_.rend(); ++each)
    if (each->isDropped)
      for (auto id = each->nodes.rbegin(); id != each->nodes.rend(); ++id)
        part.erase(*id);
  document().edit(tr("Regrow %1").arg(nodeName(node)),
                  [&](SkeletonEditor& editor) { replaceCarried(editor, node, part); });
  document().selection().set({node});
  cancel();
}

void RegrowTool::acceptBranches() {
  const Skeleton& skeleton = document().skeleton();
  std::vector<GrownBranch> wanted;
  for (std::size_t i = 0; i < shown_; ++i)
    if (!proposals_[i].isDropped) wanted.push_back(branches_[i]);
  for (const GrownBranch& branch : wanted)
    if (!skeleton.contains(branch.on) || (branch.fraction < 1 && !skeleton[branch.on].parent))
      throw Error(tr("%1 is gone, which was to carry a branch: drop this, and grow it again")
                      .arg(nodeName(branch.on))
                      .toStdString());
  std::vector<NodeId> added;
  document().edit(text_, [&](SkeletonEditor& editor) {
    for (const std::vector<NodeId>& first : addGrown(editor, wanted))
      added.insert(added.end(), first.begin(), first.end());
  });
  document().selection().set(downstream(document().skeleton(), added));
  cancel();
}

void RegrowTool::clear() {
  node_.reset();
  part_ = {};
  branches_.clear();
  proposals_.clear();
  shown_ = 0;
}

void RegrowTool::cancel() {
  if (!hasPreview()) return;
  clear();
  canvas().showPreview({});
  emit finished();
}

void RegrowTool::startWith(const std::vector<NodeId>& nodes) {
  if (nodes.size() > 1) throw Error(tr("one node is regrown at a time: select one").toStdString());
  emit wanted(nodes.front());
}

void RegrowTool::show(NodeId node, const Skeleton& part) {
  clear();
  node_ = node;
  carried_ = downstream(document().skeleton(), {node}).size() - 1;
  part_ = part;
  std::vector<std::size_t> proposalOf(part.idEnd(), 0);
  for (const Axis& axis : axes(part)) { // carriers first
    Proposal proposal;
    for (const NodeId id : axis) {
      const Node& each = part[id];
      proposalOf[indexOf(id)] = proposals_.size();
      proposal.places.push_back(each.position);
      if (!each.parent) continue;
      const Eigen::Vector3d& below = part[*each.parent].position;
      if (id == axis.front()) {
        proposal.on = proposalOf[indexOf(*each.parent)];
        proposal.places.push_back(below);
      }
      proposal.nodes.push_back(id);
      proposal.look.lines.push_back({below, each.position});
      proposal.look.nodes.push_back(each.position);
      proposal.length += (each.position - below).norm();
    }
    proposals_.push_back(std::move(proposal));
  }
  begin();
}

void RegrowTool::show(std::vector<GrownBranch> branches, const QString& text, double least) {
  clear();
  text_ = text;
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < branches.size(); ++i)
    order.emplace_back(lengthOf(branches[i].part), i);
  std::ranges::stable_sort(order, std::greater<>(), &std::pair<double, std::size_t>::first);
  for (const auto& [length, i] : order) {
    Proposal proposal{.places = placesOf(branches[i].part), .look = {}, .length = length, .on = {}};
    addTo(proposal.look, branches[i].part);
    proposals_.push_back(std::move(proposal));
    branches_.push_back(std::move(branches[i]));
  }
  const auto isLong = [least](const Proposal& each) { return each.length >= least; };
  shown_ = std::max<std::size_t>(1, std::size_t(std::ranges::count_if(proposals_, isLong)));
  begin();
}

void RegrowTool::begin() {
  preview();
  if (const std::optional<std::size_t> at = current()) emit reached(proposals_[*at].places);
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

/// All that is not dropped; the nodes are those of the one that is to be chosen, if there is one.
void RegrowTool::preview() {
  const std::optional<std::size_t> at = current();
  Preview preview;
  const auto add = [&](const Proposal& proposal, bool withNodes) {
    const Preview& look = proposal.look;
    preview.lines.insert(preview.lines.end(), look.lines.begin(), look.lines.end());
    if (withNodes) preview.nodes.insert(preview.nodes.end(), look.nodes.begin(), look.nodes.end());
  };
  for (std::size_t i = 0; i < shown(); ++i)
    if (!proposals_[i].isDropped && i != at) add(proposals_[i], !at.has_value());
  if (at) {
    add(proposals_[*at], true); // last: its label is at its end
    preview.label = tr("%1 of %2", "branch").arg(*at + 1).arg(shown());
  }
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
