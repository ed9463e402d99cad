#include "ui/tools/select_points_tool.h"

#include <QLineF>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {
namespace {

constexpr double thinnest = 3; // logical pixels
constexpr double widest = 300;

/// What a disc covers that is drawn from one place to another, closed.
QPolygonF sweep(const QPointF& from, const QPointF& to, double radius) {
  constexpr int half = 16; // corners of half a disc
  const QLineF line(from, to);
  const double turn = line.length() > 0 ? std::atan2(line.dy(), line.dx()) : 0;
  QPolygonF area;
  for (int i = 0; i <= 2 * half + 1; ++i) {
    const bool isAtEnd = i <= half;
    const double angle =
        turn + (-0.5 + static_cast<double>(isAtEnd ? i : i - 1) / half) * std::numbers::pi;
    area.append((isAtEnd ? to : from) + radius * QPointF(std::cos(angle), std::sin(angle)));
  }
  area.append(area.first());
  return area;
}

} // namespace

QString SelectPointsTool::hint() const {
  if (isCanceled_) return tr("As before. Release the button");
  if (!document().scan()) return tr("There are no points to select: open the scan first");
  if (how_ && !purpose_.isEmpty())
    return tr("Release: these points are %1   Esc: leave it").arg(purpose_);
  if (how_)
    return shape_ == Shape::brush ? tr("Release: select the points painted   Esc: leave it")
                                  : tr("Release: select the points inside   Esc: leave it");
  if (clicks_.isBegun()) return clicks_.hint();
  QString hint = hintOfShape();
  if (!purpose_.isEmpty()) return tr("Points become %1   ").arg(purpose_) + hint;
  if (!document().pointSelection().isEmpty())
    hint += tr("   {remove} set aside   {remove_subtree} keep only");
  return hint;
}

QString SelectPointsTool::hintOfShape() const {
  const QString how = tr("%1   Shift: add   Alt: take away   Ctrl: only turn view   "
                         "{points_shape} %2");
  switch (shape_) {
  case Shape::brush:
    return how.arg(tr("Drag: paint points"), tr("box")) +
           tr("   {brush_larger} larger   {brush_smaller} smaller");
  case Shape::box:
    return how.arg(tr("Drag: box about points"), tr("lasso"));
  case Shape::lasso:
    return how.arg(tr("Drag: lasso about points"), tr("brush"));
  case Shape::thing:
    break;
  }
  return tr("%1   Shift: add   Alt: take away   Drag: turn   {points_shape} brush")
      .arg(clicks_.hint());
}

void SelectPointsTool::cancel() {
  area_.cancel();
  clicks_.cancel();
  emit hintChanged();
  if (!how_ || isCanceled_) return;
  document().pointSelection().set(before_);
  isCanceled_ = true;
}

void SelectPointsTool::leave() {
  clicks_.cancel();
}

void SelectPointsTool::setThing(PointQuestion::Thing thing) {
  setShape(Shape::thing);
  clicks_.begin(thing);
  emit hintChanged();
}

void SelectPointsTool::setShape(Shape shape) {
  if (isBusy()) cancel();
  shape_ = shape;
  showBrush();
  emit hintChanged();
}

void SelectPointsTool::setPurpose(const QString& purpose) {
  if (purpose == purpose_) return;
  purpose_ = purpose;
  emit hintChanged();
}

void SelectPointsTool::setBrushSize(double radius) {
  brush_ = std::clamp(radius, thinnest, widest);
  showBrush();
}

bool SelectPointsTool::act(const ToolInput& input) {
  if (shape_ == Shape::thing) return click(input);
  switch (input.phase) {
  case ToolInput::Phase::hover:
    if (isBusy()) reset(); // canceled: the release is not sent
    pointer_ = input.screen;
    showBrush();
    return false;
  case ToolInput::Phase::press:
    if (input.button != Qt::LeftButton || !document().scan()) return false;
    press(input);
    return true;
  case ToolInput::Phase::drag:
    if (!isBusy()) return false;
    if (shape_ == Shape::brush)
      paint(input);
    else
      area_.drag(input);
    return true;
  case ToolInput::Phase::release: {
    if (!isBusy()) return false;
    if (shape_ != Shape::brush) endArea(input);
    const bool isDone = !isCanceled_;
    reset();
    if (isDone) emit ended();
    return true;
  }
  default:
    return false;
  }
}

/// A drag is the camera's.
bool SelectPointsTool::click(const ToolInput& input) {
  const bool isLeft = input.button == Qt::LeftButton && document().scan() != nullptr &&
                      !input.modifiers.testFlag(Qt::ControlModifier);
  if (input.phase == ToolInput::Phase::hover)
    clicks_.hover(input);
  else if (input.phase == ToolInput::Phase::press && isLeft)
    clicks_.press(input);
  else if (input.phase == ToolInput::Phase::drag)
    clicks_.drag(input);
  else if (input.phase == ToolInput::Phase::release)
    if (const std::optional<PointQuestion> question = clicks_.release(input))
      emit asked(*question, [this, how = howBy(input.modifiers)](const PointSet& points) {
        PointSelection& selection = document().pointSelection();
        selection.set(joined(selection.points(), points, how));
        emit ended();
      });
  return false;
}

SelectPointsTool::How SelectPointsTool::howBy(Qt::KeyboardModifiers modifiers) {
  if (modifiers.testFlag(Qt::AltModifier)) return How::takeAway;
  return modifiers.testFlag(Qt::ShiftModifier) ? How::add : How::replace;
}

void SelectPointsTool::press(const ToolInput& input) {
  how_ = howBy(input.modifiers);
  before_ = document().pointSelection().points();
  painted_ = {};
  pointer_ = input.screen;
  if (shape_ == Shape::brush)
    paint(input);
  else
    area_.begin(shape_ == Shape::box ? AreaGesture::Shape::box : AreaGesture::Shape::lasso, input);
}

void SelectPointsTool::paint(const ToolInput& input) {
  const QPointF from = pointer_.value_or(input.screen);
  pointer_ = input.screen;
  showBrush();
  if (isCanceled_) return;
  painted_ = painted_ |
             PointSet::of(canvas().pointsInside(sweep(from, input.screen, brush_), input.depth));
  choose(painted_);
}

void SelectPointsTool::endArea(const ToolInput& input) {
  const bool isClick = !area_.hasMoved() && !area_.isCanceled();
  const std::optional<QPolygonF> area = area_.end();
  if (area)
    choose(PointSet::of(canvas().pointsInside(*area, input.depth)));
  else if (isClick)
    choose({});
}

void SelectPointsTool::choose(const PointSet& points) {
  document().pointSelection().set(joined(before_, points, *how_));
}

PointSet SelectPointsTool::joined(const PointSet& before, const PointSet& points, How how) {
  return how == How::replace ? points : how == How::add ? before | points : before - points;
}

void SelectPointsTool::showBrush() {
  if (shape_ == Shape::brush && pointer_ && document().scan())
    canvas().showBand(sweep(*pointer_, *pointer_, brush_));
  else if (!area_.isActive())
    canvas().showBand({});
}

void SelectPointsTool::reset() {
  if (area_.isActive()) (void)area_.end();
  how_.reset();
  isCanceled_ = false;
  before_ = painted_ = {};
}

} // namespace espalier
