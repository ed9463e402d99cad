#include "ui/panels/option_slider.h"

#include <QMouseEvent>
#include <QPainter>
#include <QStyle>
#include <QStyleOptionSlider>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr int steps = 1000;
constexpr double fineness = 0.1; // of a move of the mouse, with Shift

} // namespace

OptionSlider::OptionSlider(QWidget* parent) : QSlider(Qt::Horizontal, parent) {
  setRange(0, steps);
  setPageStep(steps / 20);
  setFocusPolicy(Qt::StrongFocus);
}

void OptionSlider::setPlace(double place) {
  setValue(static_cast<int>(std::lround(place * steps)));
}

void OptionSlider::setDefaultPlace(double place) {
  defaultPlace_ = place;
  update();
}

double OptionSlider::place() const {
  return static_cast<double>(value()) / steps;
}

void OptionSlider::paintEvent(QPaintEvent* event) {
  QStyleOptionSlider option;
  initStyleOption(&option);
  const QRect handle =
      style()->subControlRect(QStyle::CC_Slider, &option, QStyle::SC_SliderHandle, this);
  const int span = width() - handle.width();
  const int x = handle.width() / 2 + QStyle::sliderPositionFromValue(
                                         0, steps, static_cast<int>(steps * defaultPlace_), span);
  QPainter painter(this);
  painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 2));
  painter.drawLine(x, height() / 2 - 7, x, height() / 2 + 7);
  painter.end();
  QSlider::paintEvent(event);
}

void OptionSlider::mouseDoubleClickEvent(QMouseEvent* event) {
  emit defaultRequested();
  event->accept();
}

void OptionSlider::mouseMoveEvent(QMouseEvent* event) {
  const double x = event->position().x();
  if (!fine_ && isSliderDown() && event->modifiers().testFlag(Qt::ShiftModifier))
    fine_ = FineDrag{x, static_cast<double>(value())};
  if (!fine_) {
    QSlider::mouseMoveEvent(event);
    return;
  }
  const double moved = fineness * (x - fine_->x) * steps / std::max(width(), 1);
  *fine_ = {x, std::clamp(fine_->value + moved, 0.0, static_cast<double>(steps))};
  setValue(static_cast<int>(std::lround(fine_->value)));
  event->accept();
}

void OptionSlider::mouseReleaseEvent(QMouseEvent* event) {
  fine_.reset();
  QSlider::mouseReleaseEvent(event);
}

void OptionSlider::wheelEvent(QWheelEvent* event) {
  event->ignore();
}

} // namespace espalier
