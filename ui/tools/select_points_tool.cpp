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
  if (isBusy())
    return shape_ == Shape::brush ? tr("Release: select the points painted   Esc: leave it")
                                  : tr("Release: select the points inside   Esc: leave it");
  const QString verb = shape_ == Shape::brush ? tr("Drag: paint points")
                       : shape_ == Shape::box ? tr("Drag: box about points")
                                              : tr("Drag: lasso about points");
  QString hint = tr("%1   Shift: add   Alt: take away   Ctrl: only turn view   {points_shape} %2")
                     .arg(verb, shape_ == Shape::brush ? tr("box")
                                : shape_ == Shape::box ? tr("lasso")
                                                       : tr("brush"));
  if (shape_ == Shape::brush) hint += tr("   {brush_larger} larger   {brush_smaller} smaller");
  if (!document().pointSelection().isEmpty())
    hint += tr("   {remove} set aside   {remove_subtree} keep only");
  return hint;
}

void SelectPointsTool::cancel() {
  area_.cancel();
  if (!isBusy() || isCanceled_) return;
  document().pointSelection().set(before_);
  isCanceled_ = true;
}

void SelectPointsTool::setShape(Shape shape) {
  if (isBusy()) cancel();
  shape_ = shape;
  showBrush();
  emit hintChanged();
}

void SelectPointsTool::setBrushSize(double radius) {
  brush_ = std::clamp(radius, thinnest, widest);
  showBrush();
}

bool SelectPointsTool::act(const ToolInput& input) {
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
  case ToolInput::Phase::release:
    if (!isBusy()) return false;
    if (shape_ != Shape::brush) endArea(input);
    reset();
    return true;
  default:
    return false;
  }
}

void SelectPointsTool::press(const ToolInput& input) {
  how_ = How::replace;
  if (input.modifiers.testFlag(Qt::ShiftModifier)) how_ = How::add;
  if (input.modifiers.testFlag(Qt::AltModifier)) how_ = How::takeAway;
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
  document().pointSelection().set(*how_ == How::replace ? points
                                  : *how_ == How::add   ? before_ | points
                                                        : before_ - points);
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
