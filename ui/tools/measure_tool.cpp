#include "ui/tools/measure_tool.h"

#include "ui/tools/screen_plane.h"

#include <QStringList>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace espalier {
namespace {

/// Between the directions from `at` to the others [degrees].
double angle(const Eigen::Vector3d& a, const Eigen::Vector3d& at, const Eigen::Vector3d& b) {
  const Eigen::Vector3d u = a - at;
  const Eigen::Vector3d v = b - at;
  return std::atan2(u.cross(v).norm(), u.dot(v)) * 180 / std::numbers::pi;
}

} // namespace

MeasureTool::MeasureTool(PlantDocument& document, Canvas& canvas, QObject* parent)
    : Tool(document, canvas, parent) {
  connect(&document, &PlantDocument::skeletonEdited, this, &MeasureTool::follow);
  connect(&document, &PlantDocument::unitChanged, this, &MeasureTool::show);
  for (auto signal : {&PlantDocument::skeletonReplaced, &PlantDocument::scanChanged})
    connect(&document, signal, this, &MeasureTool::cancel);
}

QString MeasureTool::hint() const {
  switch (marks_.size()) {
  case 0:
    return tr("Click two nodes, edges or points: the distance between them   Drag: turn");
  case 1:
    return tr("Click the other end   Esc: leave it");
  case 2:
    return tr("%1   Click: the angle at the second   {copy} copy   Esc: clear").arg(result());
  default:
    return tr("%1   Click: measure something else   {copy} copy   Esc: clear").arg(result());
  }
}

QString MeasureTool::result() const {
  return marks_.size() < 2 ? QString() : describe(marks_, QStringLiteral("   "));
}

void MeasureTool::cancel() {
  marks_.clear();
  next_.reset();
  press_.reset();
  show();
}

bool MeasureTool::act(const ToolInput& input) {
  switch (input.phase) {
  case ToolInput::Phase::hover:
    next_ = markOf(input.pick);
    show();
    return false;
  case ToolInput::Phase::press:
    press_.reset();
    if (input.button == Qt::LeftButton && !input.modifiers.testFlag(Qt::ControlModifier))
      press_ = input.screen;
    return false; // a drag is the camera's
  case ToolInput::Phase::drag:
    if (press_ && isDragged(*press_, input.screen)) press_.reset();
    return false;
  case ToolInput::Phase::release:
    if (const auto mark = markOf(input.pick); std::exchange(press_, {}) && mark) add(*mark);
    return false;
  default:
    return false;
  }
}

void MeasureTool::takeNode(NodeId id) {
  const std::optional<SkeletonPlace> last = marks_.empty() ? std::nullopt : marks_.back().place;
  if (!last || last->node != id || last->fraction != 1) add({.place = SkeletonPlace{id}});
}

void MeasureTool::add(const Mark& mark) {
  if (marks_.size() == 3) marks_.clear();
  marks_.push_back(mark);
  show();
}

void MeasureTool::follow() {
  const auto isGone = [this](const Mark& mark) {
    return mark.place && !document().skeleton().contains(mark.place->node);
  };
  if (next_ && isGone(*next_)) next_.reset();
  if (std::ranges::any_of(marks_, isGone)) marks_.clear();
  show();
}

/// The path to what is under the pointer is shown before it is clicked.
void MeasureTool::show() {
  std::vector<Mark> shown = marks_;
  if (marks_.size() == 1 && next_) shown.push_back(*next_);
  Preview preview;
  std::vector<Eigen::Vector3d> line;
  line.reserve(shown.size());
  for (const Mark& mark : shown)
    line.push_back(positionOf(mark));
  preview.nodes = line;
  if (line.size() > 1) {
    preview.lines = {line};
    preview.label = describe(shown, QStringLiteral(" · "));
  }
  if (preview.isEmpty() && !isShown_) return; // what is shown is another tool's
  isShown_ = !preview.isEmpty();
  canvas().showPreview(preview);
  emit hintChanged();
}

std::optional<MeasureTool::Mark> MeasureTool::markOf(const Pick& pick) {
  if (pick.node) return Mark{.place = SkeletonPlace{*pick.node}};
  if (pick.edge) return Mark{.place = SkeletonPlace{pick.edge->child, pick.edge->fraction}};
  if (pick.point) return Mark{.place = {}, .point = *pick.point};
  return std::nullopt;
}

Eigen::Vector3d MeasureTool::positionOf(const Mark& mark) const {
  return mark.place ? espalier::positionOf(document().skeleton(), *mark.place) : mark.point;
}

/// Of three: the angle and both lengths.
QString MeasureTool::describe(const std::vector<Mark>& marks, const QString& between) const {
  const LengthUnit unit = document().unit();
  const auto straight = [&](std::size_t i) {
    return formatLength((positionOf(marks[i]) - positionOf(marks[i + 1])).norm(), unit);
  };
  if (marks.size() == 3) {
    const double degrees = angle(positionOf(marks[0]), positionOf(marks[1]), positionOf(marks[2]));
    return QStringList{tr("angle %1°").arg(degrees, 0, 'f', 1), straight(0), straight(1)}.join(
        between);
  }
  QStringList parts = {tr("straight %1").arg(straight(0))};
  if (marks[0].place && marks[1].place) {
    const auto along = lengthAlong(document().skeleton(), *marks[0].place, *marks[1].place);
    parts.append(along ? tr("along the plant %1").arg(formatLength(*along, unit))
                       : tr("in different trees"));
  }
  return parts.join(between);
}

} // namespace espalier
