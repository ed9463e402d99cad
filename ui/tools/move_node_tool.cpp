#include "ui/tools/move_node_tool.h"

#include "core/cloud/middle_of_nearest.h"
#include "core/skeleton/edits.h"
#include "core/skeleton/recenter.h"
#include "core/skeleton/slide.h"
#include "ui/tools/node_edits.h"
#include "ui/tools/screen_plane.h"

#include <algorithm>
#include <iterator>
#include <unordered_set>
#include <utility>

namespace espalier {
namespace {

constexpr std::size_t mostSnapping = 50; // nodes that snap while the pointer moves

} // namespace

MoveNodeTool::MoveNodeTool(PlantDocument& document, Canvas& canvas, QObject* parent)
    : Tool(document, canvas, parent), area_(canvas) {
  rest_.setSingleShot(true);
  connect(&rest_, &QTimer::timeout, this, &MoveNodeTool::snapResting);
}

QString MoveNodeTool::hint() const {
  if (area_.isActive()) return areaHint();
  if (drag_ && drag_->isCanceled) return tr("Put back. Release the button");
  if (drag_ && drag_->hasMoved) return dragHint();
  if (document().isReadOnly() && (under().node || under().edge))
    return tr("Click: select %1   Drag: turn   Right drag: pan")
        .arg(nodeName(under().node ? *under().node : under().edge->child));
  if (under().node && document().selection().contains(*under().node))
    return document().selection().nodes().size() > 1
               ? tr("Drag: move the %n nodes   Click: select this one alone   Shift+click: leave "
                    "it out   "
                    "{new_child} new child   {tool_reparent} reparent   {remove} remove",
                    nullptr, static_cast<int>(document().selection().nodes().size()))
               : tr("Drag: move %1   {new_child} new child   {split_edge} split edge   "
                    "{tool_reparent} reparent   {remove} remove")
                     .arg(nodeName(*under().node));
  if (under().node)
    return tr("Click: select %1   Drag: move it   {new_child} new child   {split_edge} split edge  "
              " "
              "{tool_reparent} reparent   {remove} remove")
        .arg(nodeName(*under().node));
  if (under().edge)
    return tr("Click: select %1   {split_edge}: split the edge here   Drag: turn   Right drag: pan")
        .arg(nodeName(under().edge->child));
  return tr("Drag: turn   Right drag: pan   Wheel: zoom   Click a node: select it   "
            "Shift+drag: box   Alt+drag: lasso");
}

QString MoveNodeTool::dragHint() const {
  const bool isAlone = drag_->start.size() == 1;
  const QString end = isAlone ? tr("Release: leave it here   Esc: put it back")
                              : tr("Release: leave them here   Esc: put them back");
  QStringList parts;
  if (drag_->slides) parts.append(tr("Along its axis"));
  if (drag_->snap == Snap::contracted)
    parts.append(document().contracted() ? tr("On the contracted points")
                                         : tr("No contracted points: reconstruct first"));
  if (drag_->snap == Snap::section)
    parts.append(isAlone ? tr("In the middle of its section")
                         : tr("Each in the middle of its section"));
  parts.append(end);
  if (isAlone && !drag_->slides) parts.append(tr("Shift: along its axis"));
  if (drag_->snap == Snap::nothing)
    parts.append(snap_ == Snap::nothing ? tr("Ctrl: to the section center") : QString());
  else if (snap_ != Snap::nothing)
    parts.append(tr("Ctrl: freely"));
  parts.removeAll(QString());
  return parts.join(QStringLiteral("   "));
}

void MoveNodeTool::setSnap(Snap snap) {
  snap_ = snap;
  emit hintChanged();
}

QString MoveNodeTool::areaHint() const {
  if (area_.isCanceled()) return tr("Nothing selected. Release the button");
  return tr("Release: select the nodes inside, with Shift in addition   Esc: leave it");
}

void MoveNodeTool::cancel() {
  area_.cancel();
  rest_.stop();
  if (!drag_) return;
  document().cancel(drag_->gesture);
  drag_->isCanceled = true;
}

bool MoveNodeTool::act(const ToolInput& input) {
  switch (input.phase) {
  case ToolInput::Phase::press:
    return press(input);
  case ToolInput::Phase::drag:
    if (area_.isActive()) {
      area_.drag(input);
      return true;
    }
    if (camera_ && isDragged(*camera_, input.screen)) camera_.reset();
    if (!drag_) return false;
    drag(input);
    return true;
  case ToolInput::Phase::release: {
    if (area_.isActive()) {
      endArea(input);
      return true;
    }
    const bool wasMine = drag_.has_value();
    if (wasMine) release();
    drag_.reset();
    if (!wasMine) click(input);
    camera_.reset();
    return wasMine;
  }
  case ToolInput::Phase::hover: // a release elsewhere is not sent, as after a change of windows
    if (drag_ && drag_->isCanceled) drag_.reset();
    return false;
  default:
    return false;
  }
}

bool MoveNodeTool::press(const ToolInput& input) {
  rest_.stop();
  drag_.reset();
  camera_.reset();
  if (const auto shape = AreaGesture::shapeOf(input)) {
    area_.begin(*shape, input);
    pressedOn_ = input.pick;
    return true;
  }
  if (input.button != Qt::LeftButton || input.modifiers.testFlag(Qt::ControlModifier)) return false;
  if (!input.pick.node || document().isReadOnly()) {
    camera_ = input.screen;
    return false;
  }
  const NodeId node = *input.pick.node;
  if (!document().selection().contains(node)) document().selection().set({node});
  const auto plane = screenPlane(document().skeleton()[node].position, input);
  const std::optional<Eigen::Vector3d> grip = meet(plane, input);
  if (!grip) return true; // nothing to drag
  drag_ = Drag{.node = node,
               .start = {},
               .plane = plane,
               .grip = *grip,
               .gesture = Gesture::begin(),
               .screen = input.screen};
  for (const NodeId id : document().selection().nodes())
    drag_->start.emplace_back(id, document().skeleton()[id].position);
  if (drag_->start.size() > mostSnapping) {
    const Eigen::Vector3d held = document().skeleton()[node].position;
    std::ranges::nth_element(
        drag_->start, drag_->start.begin() + mostSnapping, {},
        [&](const auto& moved) { return (moved.second - held).squaredNorm(); });
  }
  return true;
}

/// Of several nodes that are selected, a click takes the one it is on.
void MoveNodeTool::release() {
  if (drag_->hasMoved || drag_->isCanceled)
    snapAll();
  else
    document().selection().set({drag_->node});
}

void MoveNodeTool::drag(const ToolInput& input) {
  if (drag_->isCanceled) return;
  drag_->hasMoved = drag_->hasMoved || isDragged(drag_->screen, input.screen);
  const std::optional<Eigen::Vector3d> at = meet(drag_->plane, input);
  if (!drag_->hasMoved || !at) return;
  const auto change = [&](SkeletonEditor& editor) {
    move(editor, *at - drag_->grip, input);
    drag_->snapped = 0;
    snapMore(editor);
  };
  document().edit(editText(), change, drag_->gesture);
  constexpr int pause = 60; // [ms]
  if (drag_->snapped < drag_->start.size()) rest_.start(pause);
}

/// In parts, so that the pointer is followed again at once when it moves on.
void MoveNodeTool::snapResting() {
  if (!drag_ || drag_->isCanceled || drag_->snapped >= drag_->start.size()) return;
  document().edit(
      editText(), [&](SkeletonEditor& editor) { snapMore(editor); }, drag_->gesture);
  rest_.start(0);
}

void MoveNodeTool::snapAll() {
  rest_.stop();
  if (!drag_->hasMoved || drag_->isCanceled || drag_->snapped >= drag_->start.size()) return;
  const auto change = [&](SkeletonEditor& editor) {
    while (drag_->snapped < drag_->start.size())
      snapMore(editor);
  };
  document().edit(editText(), change, drag_->gesture);
}

QString MoveNodeTool::editText() const {
  return drag_->start.size() == 1
             ? tr("Move %1").arg(nodeName(drag_->node))
             : tr("Move %n nodes", nullptr, static_cast<int>(drag_->start.size()));
}

void MoveNodeTool::move(SkeletonEditor& editor, const Eigen::Vector3d& shift,
                        const ToolInput& input) {
  const auto& [first, start] = drag_->start.front();
  const bool isAlone = drag_->start.size() == 1;
  drag_->slides = isAlone && input.modifiers.testFlag(Qt::ShiftModifier);
  drag_->snap = snap_;
  if (input.modifiers.testFlag(Qt::ControlModifier))
    drag_->snap = snap_ == Snap::nothing ? Snap::section : Snap::nothing;
  std::optional<Eigen::Vector3d> slid;
  if (drag_->slides) // looked for where the pointer holds it, not where the pointer is
    slid = slidAlongAxis(editor.skeleton(), first, start,
                         {input.ray.origin() + start - drag_->grip, input.ray.direction()});
  for (const auto& [id, from] : drag_->start)
    moveNode(editor, id, slid.value_or(from + shift));
}

void MoveNodeTool::snapMore(SkeletonEditor& editor) {
  const std::size_t first = drag_->snapped;
  drag_->snapped = std::min(first + mostSnapping, drag_->start.size());
  const int rounds = drag_->snap == Snap::section ? 2 : 1; // from nearer, all of it is in reach
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = first; i < drag_->snapped; ++i) {
      const NodeId id = drag_->start[i].first;
      if (const auto on = snapped(editor.skeleton(), id)) moveNode(editor, id, *on);
    }
}

std::optional<Eigen::Vector3d> MoveNodeTool::snapped(const Skeleton& skeleton, NodeId id) const {
  const Scan* scan = document().scan();
  if (scan == nullptr || drag_->snap == Snap::nothing) return std::nullopt;
  const Eigen::Vector3d& place = skeleton[id].position;
  const double reach = sectionReach(document(), id);
  if (drag_->snap == Snap::section) return sectionCenter(skeleton, id, scan->near(place, reach));
  if (!document().contracted()) return std::nullopt;
  return middleOfNearest(*document().contracted(), scan->cloud()->origin(), scan->leftOut(), place,
                         reach);
}

void MoveNodeTool::click(const ToolInput& input) {
  if (!camera_ || isDragged(*camera_, input.screen)) return;
  choose(input.pick, false);
}

void MoveNodeTool::endArea(const ToolInput& input) {
  const bool adds = input.modifiers.testFlag(Qt::ShiftModifier);
  const bool isClick = !area_.hasMoved() && !area_.isCanceled();
  const std::optional<QPolygonF> area = area_.end();
  if (isClick) choose(pressedOn_, adds);
  if (!area) return;
  std::vector<NodeId> inside = canvas().nodesInside(*area, input.depth);
  if (adds) {
    std::vector<NodeId> chosen = document().selection().nodes();
    const std::unordered_set<NodeId> before(chosen.begin(), chosen.end());
    std::ranges::copy_if(inside, std::back_inserter(chosen),
                         [&](NodeId id) { return !before.contains(id); });
    inside = std::move(chosen);
  }
  document().selection().set(std::move(inside));
}

void MoveNodeTool::choose(const Pick& pick, bool adds) {
  std::optional<NodeId> node = pick.node;
  if (!node && pick.edge) node = pick.edge->child;
  if (node && adds)
    document().selection().toggle(*node);
  else if (node)
    document().selection().set({*node});
  else if (!adds)
    document().selection().clear();
}

} // namespace espalier
