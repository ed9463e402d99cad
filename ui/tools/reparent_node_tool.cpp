#include "ui/tools/reparent_node_tool.h"

#include "core/base/error.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/tree_edits.h"
#include "ui/document/length_unit.h"
#include "ui/tools/node_edits.h"
#include "ui/tools/screen_plane.h"

#include <algorithm>
#include <utility>

namespace espalier {

ReparentNodeTool::ReparentNodeTool(PlantDocument& document, Canvas& canvas, QObject* parent)
    : Tool(document, canvas, parent) {
  connect(&document.selection(), &Selection::changed, this, &ReparentNodeTool::followSelection);
}

QString ReparentNodeTool::hint() const {
  if (moving_.empty()) return tr("Drag a node onto its new parent, or click one after the other");
  const QString names = nodeNames(moving_);
  const std::optional<Pick> to = aim();
  if (to && isCarried(*to))
    return tr("Not there: it grows from %1   Choose a parent elsewhere   Esc: leave it").arg(names);
  if (isDragging_ && to && to->node)
    return tr("Release: attach %1 to %2   Esc: put it back").arg(names, nodeName(*to->node));
  if (isDragging_ && to)
    return tr("Release: attach %1 here on the edge   Esc: put it back").arg(names);
  if (isDragging_) return tr("Drop %1 on its new parent   Esc: put it back").arg(names);
  if (!to) return tr("Click the new parent of %1   Drag: turn   Esc: leave it").arg(names);
  if (isByKeys_ || !isTarget(under()))
    return tr("Enter: attach %1 to %2   Arrow keys: to another   Click the new parent   "
              "Esc: leave it")
        .arg(names, nodeName(*to->node));
  if (to->node) return tr("Click: attach %1 to %2   Esc: leave it").arg(names, nodeName(*to->node));
  return tr("Click: attach %1 here on the edge   Esc: leave it").arg(names);
}

void ReparentNodeTool::accept() {
  attachTo(*aim());
}

void ReparentNodeTool::cancel() {
  end();
}

void ReparentNodeTool::startWith(const std::vector<NodeId>& nodes) {
  endsWhenDone_ = true;
  take(nodes);
}

bool ReparentNodeTool::act(const ToolInput& input) {
  dropGone();
  if (input.phase != ToolInput::Phase::hover || input.screen != pointer_) isByKeys_ = false;
  pointer_ = input.screen;
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
  missed_.reset();
  isDragging_ = false;
  if (input.button != Qt::LeftButton || input.modifiers.testFlag(Qt::ControlModifier)) return false;
  if (!moving_.empty() && isTarget(input.pick)) {
    attachTo(input.pick);
    return true;
  }
  if (!moving_.empty()) missed_ = input.screen;
  if (!input.pick.node) return false;
  if (moving_.empty()) take({*input.pick.node});
  pressed_ = input.screen;
  return true;
}

bool ReparentNodeTool::release(const ToolInput& input) {
  const auto missed = std::exchange(missed_, std::nullopt);
  if (missed && !isDragged(*missed, input.screen)) {
    pressed_.reset();
    refuseClick(input.pick);
  }
  if (!pressed_) return false;
  pressed_.reset();
  if (!std::exchange(isDragging_, false)) return true; // a click: the next one is on the parent
  if (isTarget(input.pick))
    attachTo(input.pick);
  else
    end(); // dropped on nothing
  return true;
}

void ReparentNodeTool::take(const std::vector<NodeId>& nodes) {
  moving_ = nodes;
  likely_ = likelyNewParent(document().skeleton(), nodes);
  document().selection().set(nodes);
  followSelection(); // also if they were selected
}

/// Steps along the plant select: where they lead is what they mean.
void ReparentNodeTool::followSelection() {
  dropGone();
  if (moving_.empty() || isDragging_) return;
  isByKeys_ = true;
  const std::optional<Pick> to = aim();
  show(to && isCarried(*to) ? std::nullopt : placeOf(to));
  emit hintChanged();
}

void ReparentNodeTool::dropGone() {
  std::erase_if(moving_, [this](NodeId id) { return !document().skeleton().contains(id); });
}

std::optional<Pick> ReparentNodeTool::aim() const {
  if (moving_.empty()) return std::nullopt;
  if (!isByKeys_ && isTarget(under())) return under();
  if (isDragging_) return std::nullopt;
  const std::vector<NodeId>& selected = document().selection().nodes();
  const bool isStepped = selected.size() == 1 && !isMoving({.node = selected.front()});
  const std::optional<NodeId> to = isStepped             ? std::optional(selected.front())
                                   : selected == moving_ ? likely_
                                                         : std::nullopt;
  const Pick pick{.node = to};
  return isTarget(pick) ? std::optional(pick) : std::nullopt;
}

bool ReparentNodeTool::isTarget(const Pick& pick) const {
  const std::optional<NodeId> at = pick.edge        ? std::optional(pick.edge->child)
                                   : isMoving(pick) ? std::nullopt
                                                    : pick.node;
  return at && document().skeleton().contains(*at);
}

/// Whether what is attached carries that place, so that it cannot be attached there.
bool ReparentNodeTool::isCarried(const Pick& target) const {
  const NodeId at = target.node ? *target.node : target.edge->child;
  return std::ranges::any_of(moving_,
                             [&](NodeId id) { return document().skeleton().isAncestor(id, at); });
}

void ReparentNodeTool::attachTo(const Pick& target) {
  if (target.edge && isCarried(target))
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

/// A click that is on no new parent says so: else nothing would be seen to happen.
void ReparentNodeTool::refuseClick(const Pick& pick) const {
  if (pick.node)
    throw Error(
        (moving_.size() == 1
             ? tr("%1 is what is attached: click the node or edge that it grows from")
                   .arg(nodeName(moving_.front()))
             : tr("%1 is one of the %2 nodes that are attached: click the node or edge that "
                  "they grow from, or press Esc and choose fewer nodes")
                   .arg(nodeName(*pick.node))
                   .arg(moving_.size()))
            .toStdString());
  throw Error(tr("no node or edge is there to attach %1 to: what points or wood hide is not "
                 "clicked; turn the plant, or choose Select > Select Through")
                  .arg(nodeNames(moving_))
                  .toStdString());
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

std::optional<Eigen::Vector3d> ReparentNodeTool::placeOf(const std::optional<Pick>& pick) const {
  if (!pick) return std::nullopt;
  return pick->node ? document().skeleton()[*pick->node].position : pick->edge->position;
}

void ReparentNodeTool::preview(const ToolInput& input) {
  const std::optional<Pick> to = aim();
  if (to && isCarried(*to)) return show(std::nullopt);
  if (to || !isDragging_ || moving_.empty()) return show(placeOf(to));
  const Eigen::Vector3d& from = document().skeleton()[moving_.front()].position;
  show(meet(screenPlane(from, input), input));
}

/// The edges that would be made to this place, with the length of the longest.
void ReparentNodeTool::show(const std::optional<Eigen::Vector3d>& end) {
  Preview shown{.lines = {}, .nodes = {}, .label = {}, .subjects = subjects()};
  double longest = 0; // [L]
  for (const Eigen::Vector3d& from : shown.subjects) {
    if (!end) break;
    shown.lines.push_back({from, *end}); // the length is written at its end
    longest = std::max(longest, (*end - from).norm());
  }
  if (!shown.lines.empty()) shown.label = formatLength(longest, document().unit());
  canvas().showPreview(shown);
}

void ReparentNodeTool::end() {
  std::vector<NodeId> moved = std::exchange(moving_, {});
  pressed_.reset();
  isDragging_ = false;
  isByKeys_ = false;
  canvas().showPreview({});
  std::erase_if(moved, [this](NodeId id) { return !document().skeleton().contains(id); });
  if (!moved.empty()) document().selection().set(moved); // not what keys have stepped to
  if (std::exchange(endsWhenDone_, false)) emit finished();
}

} // namespace espalier
