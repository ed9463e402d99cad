#include "ui/tools/stroke_tool.h"

#include "core/base/error.h"
#include "core/reconstruct/leave_wood.h"
#include "core/skeleton/branch_edits.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/path_edits.h"
#include "core/skeleton/tree_edits.h"
#include "ui/tools/node_edits.h"
#include "ui/tools/screen_plane.h"

#include <algorithm>
#include <utility>

namespace espalier {
namespace {

constexpr double reach = 12; // logical pixels that a hand is off what it means

bool cross(const QLineF& a, const QLineF& b, QPointF* at = nullptr) {
  return a.intersects(b, at) == QLineF::BoundedIntersection;
}

double lengthOf(const QPolygonF& stroke) {
  double length = 0;
  for (qsizetype i = 1; i < stroke.size(); ++i)
    length += QLineF(stroke[i - 1], stroke[i]).length();
  return length;
}

std::vector<NodeId> childrenOf(const auto& edges) {
  std::vector<NodeId> ids;
  ids.reserve(edges.size());
  for (const auto& edge : edges)
    ids.push_back(edge.child);
  return ids;
}

} // namespace

QString StrokeTool::hint() const {
  if (isCanceled_) return tr("Taken back. Release the button");
  if (isWaiting_) return tr("Finding the middle of the wood   Esc: drop");
  const QString keys = tr("Shift: only cut   Alt: only exchange   Both: only branch");
  if (!isDrawing_)
    return tr("Draw across edges: cut   Along points: branch   Around a crossing: exchange arms");
  const std::vector<NodeId> cut = childrenOf(crossed_);
  switch (kind()) {
  case Kind::cut:
    return tr("Release: cut off %1   Esc: leave it   %2").arg(nodeNames(cut), keys);
  case Kind::exchange:
    if (arms().size() != 2)
      return tr("Draw around a crossing of two branches   Esc: leave it   %1").arg(keys);
    return tr("Release: exchange the arms %1 and %2   Esc: leave it   %3")
        .arg(indexOf(arms().front()))
        .arg(indexOf(arms().back()))
        .arg(keys);
  case Kind::branch:
    return startNode_
               ? tr("Release: make a branch of %1   Esc: leave it   %2")
                     .arg(nodeName(*startNode_), keys)
               : tr("Release: make a branch along the points   Esc: leave it   %1").arg(keys);
  case Kind::nothing:
    break;
  }
  return tr("Go on: across edges, along points, or around a crossing   Esc: leave it");
}

void StrokeTool::cancel() {
  isCanceled_ = isDrawing_;
  isWaiting_ = false;
  ++question_; // an answer that is still to come is not wanted any more
  reset();
}

bool StrokeTool::act(const ToolInput& input) {
  const Skeleton& skeleton = document().skeleton();
  const auto isGone = [&](const SeenEdge& edge) { // by a key in mid-stroke
    return !skeleton.contains(edge.child) || !skeleton[edge.child].parent;
  };
  std::erase_if(seen_, isGone);
  std::erase_if(crossed_, isGone);
  std::erase_if(crossedBehind_, isGone);
  switch (input.phase) {
  case ToolInput::Phase::press:
    isCanceled_ = false;
    if (input.button != Qt::LeftButton || input.modifiers.testFlag(Qt::ControlModifier) ||
        isWaiting_)
      return false;
    press(input);
    return true;
  case ToolInput::Phase::drag:
    if (isDrawing_) drag(input);
    return isDrawing_ || isCanceled_;
  case ToolInput::Phase::release: {
    const bool wasMine = isDrawing_ || std::exchange(isCanceled_, false);
    if (isDrawing_) release();
    return wasMine;
  }
  default:
    return false;
  }
}

void StrokeTool::press(const ToolInput& input) {
  reset();
  isDrawing_ = true;
  modifiers_ = input.modifiers;
  stroke_ = {input.screen};
  startNode_ = input.pick.node;
  startEdge_ = input.pick.edge;
  if (startNode_)
    places_.push_back(document().skeleton()[*startNode_].position);
  else if (startEdge_)
    places_.push_back(startEdge_->position);
  else if (input.pick.point)
    places_.push_back(*input.pick.point);
  const Skeleton& skeleton = document().skeleton(); // the camera rests while one draws
  std::vector<std::optional<QPointF>> places(skeleton.idEnd());
  for (const NodeId id : skeleton.ids()) { // parents first
    places[indexOf(id)] = canvas().project(skeleton[id].position);
    const std::optional<NodeId>& parent = skeleton[id].parent;
    if (parent && places[indexOf(id)] && places[indexOf(*parent)])
      seen_.push_back({id, {*places[indexOf(*parent)], *places[indexOf(id)]}});
  }
}

void StrokeTool::drag(const ToolInput& input) {
  modifiers_ = input.modifiers;
  if (QLineF(stroke_.back(), input.screen).length() < 2) return;
  findCrossed({stroke_.back(), input.screen});
  stroke_.append(input.screen);
  if (input.pick.point && goesOn(*input.pick.point, input)) places_.push_back(*input.pick.point);
  QPolygonF band = stroke_;
  if (kind() == Kind::exchange && isLoop()) band.append(stroke_.front()); // shown as an area
  canvas().showBand(band);
}

/// Through a gap between points one sees others far behind: wood goes not that steeply into depth.
bool StrokeTool::goesOn(const Eigen::Vector3d& point, const ToolInput& input) const {
  if (places_.empty()) return true;
  constexpr double steepest = 4; // in depth, per length across the screen
  const double spacing = document().scan() != nullptr ? document().scan()->spacing() : 0;
  double slack = 4 * spacing;
  if (places_.size() == 1 && startNode_ && document().skeleton().contains(*startNode_))
    slack += 2 * document().skeleton()[*startNode_].radius; // its points are before it
  if (places_.size() == 1 && startEdge_ && document().skeleton().contains(startEdge_->child))
    slack += 2 * document().skeleton()[startEdge_->child].radius;
  return (point - places_.back()).norm() <= steepest * input.ray.distance(places_.back()) + slack;
}

void StrokeTool::findCrossed(const QLineF& stretch) {
  for (const SeenEdge& edge : seen_) {
    if (!cross(edge.line, stretch)) continue;
    std::vector<SeenEdge>& crossed = isHidden(edge) ? crossedBehind_ : crossed_;
    const auto isThis = [&](const SeenEdge& other) { return other.child == edge.child; };
    if (std::ranges::none_of(crossed, isThis)) crossed.push_back(edge);
  }
}

bool StrokeTool::isHidden(const SeenEdge& edge) const {
  const QPointF margin(reach, reach);
  for (const QPointF& end : {edge.line.p1(), edge.line.p2()}) {
    const QRectF box(end - margin, end + margin);
    const std::vector<NodeId> front = canvas().nodesInside(QPolygonF(box), Depth::front);
    const NodeId parent = *document().skeleton()[edge.child].parent;
    if (std::ranges::any_of(front, [&](NodeId id) { return id == edge.child || id == parent; }))
      return false;
  }
  return true;
}

bool StrokeTool::isLoop() const {
  const double length = lengthOf(stroke_);
  const double gap = QLineF(stroke_.front(), stroke_.back()).length();
  return length > 4 * reach && gap < std::max(reach, length / 8);
}

StrokeTool::Kind StrokeTool::kind() const {
  const bool onlyCuts = modifiers_.testFlag(Qt::ShiftModifier);
  const bool onlyExchanges = modifiers_.testFlag(Qt::AltModifier);
  const Kind branch = places_.size() > 1 ? Kind::branch : Kind::nothing;
  if (onlyCuts && onlyExchanges) return branch;
  if (onlyCuts) return crossed_.empty() ? Kind::nothing : Kind::cut;
  if (onlyExchanges) return Kind::exchange;
  if (isLoop() && !crossed_.empty()) return Kind::exchange;
  // The edges at the node that the stroke starts at are met, not crossed.
  const auto isAtStart = [&](const SeenEdge& edge) {
    if (!document().skeleton().contains(edge.child)) return false;
    if (startEdge_ && edge.child == startEdge_->child) return true;
    return startNode_ &&
           (edge.child == *startNode_ || document().skeleton()[edge.child].parent == startNode_);
  };
  if (std::ranges::all_of(crossed_, isAtStart)) return branch;
  const auto meets = [&](const SeenEdge& a, const SeenEdge& b) {
    QPointF at;
    if (!cross(a.line, b.line, &at)) return false;
    return std::ranges::any_of(
        stroke_, [&](const QPointF& place) { return QLineF(place, at).length() < 2 * reach; });
  };
  const bool isOverCrossing = crossed_.size() == 2 && meets(crossed_.front(), crossed_.back());
  return isOverCrossing ? Kind::exchange : Kind::cut;
}

std::vector<NodeId> StrokeTool::arms() const {
  if (!isLoop()) return childrenOf(crossed_);
  std::vector<NodeId> leaving; // the loop, towards the apex
  const auto take = [&](const std::vector<SeenEdge>& edges) {
    for (const SeenEdge& edge : edges)
      if (!stroke_.containsPoint(edge.line.p2(), Qt::OddEvenFill)) leaving.push_back(edge.child);
  };
  take(crossed_);
  if (leaving.size() < 2) take(crossedBehind_); // where branches cross, one lies behind the other
  return leaving;
}

void StrokeTool::release() {
  switch (kind()) {
  case Kind::cut:
    cut();
    break;
  case Kind::exchange:
    exchange();
    break;
  case Kind::branch:
    askForBranch();
    break;
  case Kind::nothing:
    break;
  }
  if (!isWaiting_) reset();
}

void StrokeTool::reset() {
  isDrawing_ = false;
  stroke_.clear();
  places_.clear();
  startNode_.reset();
  startEdge_.reset();
  seen_.clear();
  crossed_.clear();
  crossedBehind_.clear();
  canvas().showBand({});
}

void StrokeTool::cut() {
  const std::vector<NodeId> ids = childrenOf(crossed_);
  reset();
  document().edit(tr("Cut off %1").arg(nodeNames(ids)), [&](SkeletonEditor& editor) {
    for (const NodeId id : ids)
      cutOff(editor, id);
  });
  document().selection().set(ids);
}

void StrokeTool::exchange() {
  const std::vector<NodeId> ids = arms();
  reset();
  if (ids.size() != 2)
    throw Error(
        tr("arms are exchanged where two branches cross: draw around one crossing").toStdString());
  document().edit(
      tr("Exchange the arms %1 and %2").arg(indexOf(ids.front())).arg(indexOf(ids.back())),
      [&](SkeletonEditor& editor) { exchangeArms(editor, ids.front(), ids.back()); });
  document().selection().set(ids);
}

void StrokeTool::askForBranch() {
  if (!document().scan())
    throw Error(tr("there are no points to draw along: open the scan first").toStdString());
  const double mean = meanEdgeLength(document().skeleton());
  constexpr double inSpacings = 9; // between nodes, as in the structures of the thesis
  isDrawing_ = false;
  isWaiting_ = true;
  const int number = ++question_;
  emit asked({.places = places_,
              .startIsFixed = hasStart(),
              .endIsFixed = false,
              .isDrawn = true,
              .options = {.step = mean > 0 ? mean : inSpacings * document().scan()->spacing(),
                          .alternatives = 0}},
             [this, number](const std::vector<Trace>& traces) {
               if (number != question_ || !isWaiting_) return;
               isWaiting_ = false;
               if (!traces.empty()) makeBranch(traces.front());
               reset();
               emit hintChanged();
             });
}

void StrokeTool::makeBranch(const Trace& trace) {
  const Skeleton& skeleton = document().skeleton();
  const bool isGone = (startNode_ && !skeleton.contains(*startNode_)) ||
                      (startEdge_ && !skeleton.contains(startEdge_->child));
  if (isGone) return; // it was removed meanwhile, and the branch with it
  const QString text =
      startNode_ ? tr("Draw a branch of %1").arg(nodeName(*startNode_)) : tr("Draw a branch");
  NodeId last{0};
  document().edit(text, [&](SkeletonEditor& editor) {
    Trace branch = trace;
    if (!branch.begin && startNode_) branch.begin = {*startNode_, 1};
    if (!branch.begin && startEdge_) branch.begin = {startEdge_->child, startEdge_->fraction};
    last = branch.begin ? addTrace(editor, branch)
                        : addBranch(editor, std::nullopt, branch.places, branch.radii);
  });
  document().selection().set({last});
}

} // namespace espalier
