#include "ui/tools/trace_tool.h"

#include "core/base/error.h"
#include "core/reconstruct/leave_wood.h"
#include "core/skeleton/branch_edits.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/select.h"
#include "core/skeleton/tree_edits.h"
#include "ui/tools/node_edits.h"
#include "ui/tools/screen_plane.h"

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

NodeId rootOf(const Skeleton& skeleton, NodeId id) {
  return upstream(skeleton, {id}).back();
}

/// Begins a trace at the end of a branch that was clicked, if it goes on with that, though the
/// course of the points alone leads to a place a little below. One that turns back from the end
/// stays as it is: its points leave the wood below.
void beginAtEnd(Trace& trace, const Skeleton& skeleton, NodeId end) {
  if (!trace.begin || !skeleton.contains(end) || !skeleton.children(end).empty()) return;
  const Node& node = skeleton[end];
  if (!node.parent) return;
  const Eigen::Vector3d along = node.position - skeleton[*node.parent].position;
  if (along.dot(trace.places[1] - node.position) <= 0) return;
  trace.begin = {end, 1};
  trace.places.front() = node.position;
}

} // namespace

QString TraceTool::hint() const {
  if (!document().scan()) return tr("There are no points to trace along: open the scan first");
  if (!start_) return tr("Click where the branch starts: a node, an edge or a point");
  if (readiness_ < 1)
    return tr("Reading the points, %1 %   Esc: drop").arg(static_cast<int>(100 * readiness_));
  if (!isHeld_ && under().node && end_ && isSameTree(*end_))
    return tr("A branch cannot end in its own tree: end it on a point   Esc: drop");
  if (!isHeld_ && hasPreview())
    return tr("Click: end it here   Enter accepts, Esc drops   Drag: turn");
  if (hasOtherPaths())
    return tr("Path %1 of %2   Tab: next path   Enter accepts, Esc drops")
        .arg(shown_ + 1)
        .arg(traces_.size());
  if (hasPreview()) return tr("Enter accepts, Esc drops   Click: end it elsewhere");
  return tr("Point along the branch, and click its end   Drag: turn   Esc: drop");
}

void TraceTool::cancel() {
  start_.reset();
  end_.reset();
  isHeld_ = false;
  ++question_; // an answer that is still to come is not wanted any more
  traces_.clear();
  pressed_.reset();
  canvas().showPreview({});
}

void TraceTool::showNextPath() {
  if (!hasOtherPaths()) return;
  shown_ = (shown_ + 1) % traces_.size();
  show();
}

void TraceTool::showReadiness(double fraction) {
  readiness_ = fraction;
  emit hintChanged();
}

bool TraceTool::act(const ToolInput& input) {
  switch (input.phase) {
  case ToolInput::Phase::press:
    pressed_.reset();
    if (input.button != Qt::LeftButton || input.modifiers.testFlag(Qt::ControlModifier))
      return false;
    pressed_ = input.screen;
    return input.pick.node.has_value();
  case ToolInput::Phase::drag:
    if (pressed_ && isDragged(*pressed_, input.screen)) pressed_.reset();
    return false;
  case ToolInput::Phase::release: {
    const auto at = std::exchange(pressed_, {});
    if (at && !isDragged(*at, input.screen)) click(input.pick);
    return false;
  }
  case ToolInput::Phase::hover: {
    const std::optional<End> end = endAt(input.pick);
    if (start_ && !isHeld_ && end && end != end_ && !(end->place - start_->place).isZero(0)) {
      end_ = end;
      if (!isSameTree(*end)) ask(*end, 0);
    }
    return false;
  }
  default:
    return false;
  }
}

void TraceTool::click(const Pick& pick) {
  const std::optional<End> end = endAt(pick);
  if (!end) return;
  if (!document().scan())
    throw Error(tr("there are no points to trace along: open the scan first").toStdString());
  if (!start_) {
    start_ = end;
    if (end->node) document().selection().set({*end->node});
    return;
  }
  requireNoLoop(*end);
  end_ = end;
  isHeld_ = true;
  ask(*end, 2);
}

std::optional<TraceTool::End> TraceTool::endAt(const Pick& pick) const {
  if (pick.node && document().skeleton().contains(*pick.node))
    return End{pick.node, {}, document().skeleton()[*pick.node].position};
  if (pick.edge && !start_) return End{{}, pick.edge, pick.edge->position};
  if (pick.point) return End{{}, {}, *pick.point};
  if (pick.edge) return End{{}, {}, pick.edge->position};
  return std::nullopt;
}

void TraceTool::ask(const End& end, int alternatives) {
  const bool startIsFixed = start_->node || start_->edge;
  const double mean = meanEdgeLength(document().skeleton());
  constexpr double inSpacings = 9; // between nodes, as in the structures of the thesis
  const double step = mean > 0 ? mean : inSpacings * document().scan()->spacing();
  const int number = ++question_;
  const auto answer = [this, end, number, isHeld = isHeld_](const std::vector<Trace>& traces) {
    const bool isWanted = start_ && (number == question_ || (!isHeld_ && !isHeld));
    if (!isWanted || traces.empty()) return;
    traces_ = traces;
    if (start_->node)
      for (Trace& trace : traces_)
        beginAtEnd(trace, document().skeleton(), *start_->node);
    shownEnd_ = end;
    shown_ = 0;
    show();
  };
  emit asked({.places = {start_->place, end.place},
              .startIsFixed = startIsFixed,
              .endIsFixed = end.node.has_value(),
              .isDrawn = false,
              .options = {.step = step, .alternatives = alternatives}},
             answer);
}

void TraceTool::show() {
  const Trace& trace = traces_[shown_];
  Preview preview{.lines = {trace.places}, .nodes = trace.places, .label = {}};
  if (start_->node || start_->edge) preview.nodes.erase(preview.nodes.begin());
  if (hasOtherPaths()) preview.label = tr("%1 of %2", "path").arg(shown_ + 1).arg(traces_.size());
  canvas().showPreview(preview);
  emit hintChanged();
}

bool TraceTool::isSameTree(const End& end) const {
  const Skeleton& skeleton = document().skeleton();
  if (!end.node || !start_ || !skeleton.contains(*end.node)) return false;
  const std::optional<NodeId> from =
      start_->edge ? std::optional(start_->edge->child) : start_->node;
  return from && skeleton.contains(*from) && rootOf(skeleton, *from) == rootOf(skeleton, *end.node);
}

void TraceTool::requireNoLoop(const End& end) const {
  if (isSameTree(end))
    throw Error(
        tr("%1 is of the same tree, the branch would be a loop: end it on a point, or cut %1 first")
            .arg(nodeName(*end.node))
            .toStdString());
}

void TraceTool::accept() {
  const Trace trace = traces_[shown_];
  std::optional<NodeId> from = start_->node ? start_->node : shownEnd_.node;
  if (start_->edge) from = start_->edge->child;
  const Skeleton& skeleton = document().skeleton();
  const bool isGone = (from && !skeleton.contains(*from)) ||
                      (trace.begin && !skeleton.contains(trace.begin->on)) ||
                      (shownEnd_.node && !skeleton.contains(*shownEnd_.node));
  if (isGone) throw Error(tr("the node it was attached to is gone: trace it again").toStdString());
  document().edit(from ? tr("Trace a branch from %1").arg(nodeName(*from)) : tr("Trace a branch"),
                  [&](SkeletonEditor& editor) { apply(editor, trace); });
  cancel();
}

void TraceTool::apply(SkeletonEditor& editor, const Trace& trace) {
  Trace branch = trace;
  std::optional<NodeId> joined = shownEnd_.node;
  if (!start_->node && !start_->edge && joined) { // from the points to a node: it is attached there
    std::ranges::reverse(branch.places);
    std::ranges::reverse(branch.radii);
    if (!branch.begin) branch.begin = {*joined, 1};
    joined.reset();
  }
  if (!branch.begin && start_->edge) branch.begin = {start_->edge->child, start_->edge->fraction};
  if (!branch.begin && start_->node) branch.begin = {*start_->node, 1};
  if (joined) {
    branch.places.pop_back();
    branch.radii.pop_back();
  }
  const NodeId last = branch.begin ? addTrace(editor, branch)
                                   : addBranch(editor, std::nullopt, branch.places, branch.radii);
  if (joined) joinTree(editor, *joined, last);
}

} // namespace espalier
