#include "ui/view/color_bar.h"

#include "ui/document/typed_number.h"
#include "ui/view/overlay_text.h"
#include "ui/view/palette.h"
#include "ui/view/value_field.h"

#include <QMouseEvent>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>

namespace espalier {
namespace {

constexpr double edgeReach = 8;     // [logical pixels] of a handle
constexpr double grip = 10;         // beside the bar
constexpr double numbers = 70;      // room left of the bar
constexpr double pressReach = 3;    // a press that moves less is a click
constexpr double leastRange = 0.01; // of the axis that a range keeps

} // namespace

ColorBar::ColorBar(QWidget* view) : QWidget(view) {
  setMouseTracking(true);
  setFocusPolicy(Qt::NoFocus); // the keys stay those of the plant
}

void ColorBar::showLegend(const Legend& legend, const LegendBox& box,
                          std::optional<ValueRange> chosen, bool dark) {
  legend_ = legend;
  chosen_ = chosen;
  dark_ = dark;
  const QRect area = box.scale.adjusted(-numbers, -grip, grip, grip).toAlignedRect();
  setGeometry(area);
  box_ = {box.veil.translated(-area.topLeft()), box.scale.translated(-area.topLeft())};
  setAccessibleName(tr("Color range of %1").arg(legend.title));
  setToolTip(tr("Drag an end to set the range, click its number to type it; "
                "double click for the usual range"));
  update();
  setVisible(true);
}

double ColorBar::placeOf(End end) const {
  return box_.placeOf(legend_, end == End::from ? legend_.from : legend_.to);
}

std::optional<ColorBar::End> ColorBar::endAt(const QPointF& place) const {
  const double bottom = std::abs(place.y() - placeOf(End::from));
  const double top = std::abs(place.y() - placeOf(End::to));
  if (std::min(bottom, top) > edgeReach) return std::nullopt;
  return bottom < top ? End::from : End::to;
}

void ColorBar::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Palette colors = espalier::palette(dark_);
  for (const End end : {End::from, End::to}) {
    const bool isLit = (dragged_ ? dragged_ : hovered_) == end;
    const double y = placeOf(end);
    const double x = box_.scale.right() + 1;
    painter.setPen(QPen(toQt(colors.backgroundBottom), 1));
    painter.setBrush(toQt(isLit ? colors.hovered : colors.text));
    painter.drawPolygon(QPolygonF({{x, y}, {x + 8, y - 5}, {x + 8, y + 5}}));
    if (!isLit) continue;
    painter.setPen(QPen(toQt(colors.hovered), 2));
    painter.drawLine(QPointF(box_.scale.left() - 2, y), QPointF(x, y));
  }
}

void ColorBar::hover(std::optional<End> end) {
  if (end == hovered_) return;
  hovered_ = end;
  if (end) {
    setCursor(Qt::SizeVerCursor);
    emit entered();
  } else {
    unsetCursor();
  }
  update();
}

void ColorBar::mousePressEvent(QMouseEvent* event) {
  const std::optional<End> end = endAt(event->position());
  if (event->button() != Qt::LeftButton || !end) return event->ignore();
  dragged_ = end;
  hasMoved_ = false;
  pressed_ = event->position();
  before_ = chosen_;
  legendBefore_ = legend_;
}

void ColorBar::mouseMoveEvent(QMouseEvent* event) {
  if (dragged_) {
    hasMoved_ = hasMoved_ || std::abs(event->position().y() - pressed_.y()) > pressReach;
    if (hasMoved_) drag(event->position());
    return;
  }
  hover(event->buttons() == Qt::NoButton ? endAt(event->position()) : std::nullopt);
  if (!hovered_) event->ignore();
}

void ColorBar::drag(const QPointF& place) {
  const ValueRange axis = legendBefore_.axis();
  const double least = leastRange * (axis.to - axis.from);
  const double value = std::clamp(box_.valueAt(legendBefore_, place.y()), axis.from, axis.to);
  ValueRange range{legendBefore_.from, legendBefore_.to};
  if (dragged_ == End::from)
    range.from = std::min(value, range.to - least);
  else
    range.to = std::max(value, range.from + least);
  emit rangeChosen(legend_.id, range, false);
}

void ColorBar::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !dragged_) return event->ignore();
  const End end = *std::exchange(dragged_, std::nullopt);
  if (hasMoved_)
    emit rangeChosen(legend_.id, range(), true);
  else if (event->position().x() < box_.scale.left())
    type(end);
  update();
}

void ColorBar::mouseDoubleClickEvent(QMouseEvent* event) {
  const bool isOnBar =
      box_.scale.adjusted(-4, -edgeReach, grip, edgeReach).contains(event->position());
  if (event->button() != Qt::LeftButton || !isOnBar) return event->ignore();
  dragged_.reset();
  emit rangeChosen(legend_.id, std::nullopt, true);
}

void ColorBar::leaveEvent(QEvent* event) {
  if (!dragged_) hover(std::nullopt);
  QWidget::leaveEvent(event);
}

void ColorBar::cancel() {
  if (!dragged_) return;
  dragged_.reset();
  emit rangeChosen(legend_.id, before_, true);
  update();
}

void ColorBar::type(End end) {
  const double value = end == End::from ? legend_.from : legend_.to;
  auto* field = new ValueField(rangeNumber(value, range(), legend_.unit), parentWidget());
  const QPointF corner = mapToParent(QPointF(0, placeOf(end) - field->sizeHint().height() / 2.0));
  field->setGeometry(QRect(corner.toPoint(), QSize(int(numbers), field->sizeHint().height())));
  field->setAccessibleName(end == End::from ? tr("Least value of the color range")
                                            : tr("Greatest value of the color range"));
  connect(field, &ValueField::typed, this, [this, end](const QString& text, bool goesOn) {
    takeTyped(end, text);
    if (goesOn) type(end == End::from ? End::to : End::from);
  });
  field->open();
}

void ColorBar::takeTyped(End end, const QString& text) {
  ValueRange typed = range();
  const std::optional<double> number = typedNumber(text);
  if (number) (end == End::from ? typed.from : typed.to) = *number;
  if (!number || !(typed.from < typed.to)) {
    const QString other =
        rangeNumber(end == End::from ? typed.to : typed.from, range(), legend_.unit);
    const QString reason = !number ? tr("This is no number: the range stays as it was")
                           : end == End::from
                               ? tr("The least value must be below %1").arg(other)
                               : tr("The greatest value must be above %1").arg(other);
    QToolTip::showText(mapToGlobal(QPoint(0, int(placeOf(end)) + 12)), reason, this);
    return;
  }
  const double before = end == End::from ? legend_.from : legend_.to;
  if (typedNumber(rangeNumber(before, range(), legend_.unit)) == number)
    return; // as it was written
  emit rangeChosen(legend_.id, typed, true);
}

} // namespace espalier
