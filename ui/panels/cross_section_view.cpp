#include "ui/panels/cross_section_view.h"

#include "ui/document/number_scale.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr double grip = 9;                    // how near the pointer takes a handle [px]
constexpr QColor nodeColor(0xe6, 0x9f, 0x00); // of what is selected, in the plant too
constexpr double leastRadius = 1;             // that a drag of the rim leaves [px]

} // namespace

CrossSectionView::CrossSectionView(QWidget* parent) : QWidget(parent) {
  setObjectName("cross_section");
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(tr("Cross-section"));
  QSizePolicy policy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  policy.setHeightForWidth(true);
  setSizePolicy(policy);
}

void CrossSectionView::setSection(std::optional<CrossSection> section, bool keepView) {
  if (isBusy()) endDrag(true);
  if (keepView && section && section_) {
    const Eigen::Vector3d middle = section_->place(middle_) - section->center;
    middle_ = {middle.dot(section->right), middle.dot(section->up)};
    section_ = std::move(section);
    isZoomed_ = true;
  } else {
    section_ = std::move(section);
    isZoomed_ = false;
  }
  update();
}

void CrossSectionView::setNode(const SectionNode& node) {
  node_ = node;
  update();
}

void CrossSectionView::setProposed(const std::optional<FittedCircle>& circle) {
  proposed_ = circle;
  if (!isZoomed_ && !isBusy()) showAll();
  update();
}

void CrossSectionView::setUnit(LengthUnit unit) {
  unit_ = unit;
  update();
}

void CrossSectionView::setEditable(bool isEditable) {
  if (!isEditable && isBusy()) endDrag(true);
  isEditable_ = isEditable;
  hovered_ = Handle::none;
  unsetCursor();
  update();
}

int CrossSectionView::heightForWidth(int width) const {
  constexpr int most = 320; // the properties below are to stay in sight
  return std::min(width, most);
}

QPointF CrossSectionView::toScreen(const Eigen::Vector2d& place) const {
  const Eigen::Vector2d d = scale_ * (place - middle_);
  return {width() / 2.0 + d.x(), height() / 2.0 - d.y()};
}

Eigen::Vector2d CrossSectionView::fromScreen(const QPointF& position) const {
  return middle_ +
         Eigen::Vector2d(position.x() - width() / 2.0, height() / 2.0 - position.y()) / scale_;
}

CrossSectionView::Handle CrossSectionView::handleAt(const QPointF& position) const {
  if (!canEdit()) return Handle::none;
  const QPointF d = position - toScreen(node_.center);
  const double distance = std::hypot(d.x(), d.y());
  const double radius = node_.radius * scale_;
  if (node_.radius > 0 && std::abs(distance - radius) <= grip && distance >= radius / 2)
    return Handle::rim;
  return distance <= grip ? Handle::center : Handle::none;
}

/// Fits the picture to the points and both circles.
void CrossSectionView::showAll() {
  constexpr double margin = 1.15;
  double reach = node_.center.norm() + node_.radius;
  if (proposed_) reach = std::max(reach, proposed_->center.norm() + proposed_->radius);
  if (section_)
    for (const Eigen::Vector2d& point : section_->points)
      reach = std::max(reach, point.norm());
  if (reach == 0 && section_) reach = section_->halfThickness;
  middle_ = Eigen::Vector2d::Zero();
  scale_ = reach > 0 ? std::max(1, std::min(width(), height())) / (2 * margin * reach) : 1;
}

void CrossSectionView::zoom(double factor, const QPointF& about) {
  if (!section_) return;
  const Eigen::Vector2d place = fromScreen(about);
  scale_ *= factor;
  middle_ += place - fromScreen(about); // what is under the pointer stays there
  isZoomed_ = true;
  update();
}

void CrossSectionView::drag(const QPointF& position) {
  const Eigen::Vector2d place = fromScreen(position) - grabbed_;
  SectionNode asked = node_;
  if (dragged_ == Handle::center)
    asked.center = place;
  else
    asked.radius = std::max((place - node_.center).norm(), leastRadius / scale_);
  emit circleAsked(asked, gesture_);
}

void CrossSectionView::endDrag(bool isKept) {
  dragged_ = Handle::none;
  if (!isKept) emit canceled(gesture_);
  gesture_ = {};
  emit dragEnded();
}

void CrossSectionView::step(const Eigen::Vector2d& shift, double factor, bool isRepeated) {
  if (!canEdit()) return;
  if (!isRepeated || gesture_.isNone()) gesture_ = Gesture::begin(); // held down: one step
  emit circleAsked({.center = node_.center + shift, .radius = node_.radius * factor}, gesture_);
  emit dragEnded();
}

bool CrossSectionView::event(QEvent* event) {
  const auto isMeant = [this](int key) {
    return isBusy() || key == Qt::Key_Plus || key == Qt::Key_Minus ||
           (key >= Qt::Key_Left && key <= Qt::Key_PageDown);
  };
  if (event->type() == QEvent::ShortcutOverride &&
      isMeant(static_cast<const QKeyEvent*>(event)->key())) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

void CrossSectionView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (!isZoomed_ && !isBusy()) showAll();
}

void CrossSectionView::mousePressEvent(QMouseEvent* event) {
  const Handle handle =
      event->button() == Qt::LeftButton ? handleAt(event->position()) : Handle::none;
  if (handle == Handle::none || isBusy()) return;
  dragged_ = handle;
  gesture_ = Gesture::begin();
  const Eigen::Vector2d place = fromScreen(event->position());
  const Eigen::Vector2d out = place - node_.center;
  grabbed_ = handle == Handle::center ? out : out * (1 - node_.radius / out.norm());
  update();
}

void CrossSectionView::mouseMoveEvent(QMouseEvent* event) {
  if (isBusy()) {
    drag(event->position());
    return;
  }
  hovered_ = handleAt(event->position());
  if (hovered_ == Handle::none)
    unsetCursor();
  else
    setCursor(hovered_ == Handle::center ? Qt::SizeAllCursor : Qt::PointingHandCursor);
  update();
}

void CrossSectionView::mouseReleaseEvent(QMouseEvent* event) {
  if (isBusy() && event->button() == Qt::LeftButton) endDrag(true);
}

void CrossSectionView::mouseDoubleClickEvent(QMouseEvent* /*event*/) {
  isZoomed_ = false;
  showAll();
  update();
}

void CrossSectionView::wheelEvent(QWheelEvent* event) {
  constexpr double perNotch = 1.2;
  if (!isBusy()) zoom(std::pow(perNotch, event->angleDelta().y() / 120.0), event->position());
  event->accept(); // the page does not scroll away below the pointer
}

void CrossSectionView::keyPressEvent(QKeyEvent* event) {
  if (isBusy()) {
    const bool isUndo = event->matches(QKeySequence::Undo);
    if (event->key() == Qt::Key_Escape || isUndo) endDrag(false);
    return;
  }
  const bool isFine = event->modifiers().testFlag(Qt::ShiftModifier);
  const double shift = (isFine ? 1 : 5) / scale_; // pixels
  const double growth = isFine ? 1.005 : 1.02;
  const QPointF center(width() / 2.0, height() / 2.0);
  const bool isRepeated = event->isAutoRepeat();
  switch (event->key()) {
  case Qt::Key_Left:
    return step({-shift, 0}, 1, isRepeated);
  case Qt::Key_Right:
    return step({shift, 0}, 1, isRepeated);
  case Qt::Key_Up:
    return step({0, shift}, 1, isRepeated);
  case Qt::Key_Down:
    return step({0, -shift}, 1, isRepeated);
  case Qt::Key_PageUp:
    return step({0, 0}, growth, isRepeated);
  case Qt::Key_PageDown:
    return step({0, 0}, 1 / growth, isRepeated);
  case Qt::Key_Plus:
    return zoom(1.2, center);
  case Qt::Key_Minus:
    return zoom(1 / 1.2, center);
  default:
    QWidget::keyPressEvent(event);
  }
}

void CrossSectionView::focusOutEvent(QFocusEvent* event) {
  if (isBusy() && event->reason() != Qt::PopupFocusReason) endDrag(true);
  QWidget::focusOutEvent(event);
  update();
}

void CrossSectionView::enterEvent(QEnterEvent* event) {
  QWidget::enterEvent(event);
  emit pointerInside(true);
}

void CrossSectionView::leaveEvent(QEvent* event) {
  QWidget::leaveEvent(event);
  hovered_ = Handle::none;
  update();
  emit pointerInside(false);
}

void CrossSectionView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath frame;
  frame.addRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  painter.fillPath(frame, palette().color(QPalette::Base));
  painter.setPen(palette().color(hasFocus() ? QPalette::Link : QPalette::Mid));
  painter.drawPath(frame);
  if (!section_) return;
  painter.setClipPath(frame);
  paintPoints(painter);
  paintCircles(painter);
  paintScale(painter);
}

/// Own points as dots, those of other branches as faint rings.
void CrossSectionView::paintPoints(QPainter& painter) const {
  const QRectF seen = QRectF(rect()).adjusted(-3, -3, 3, 3);
  QColor faint = palette().color(QPalette::PlaceholderText);
  faint.setAlphaF(0.55F);
  painter.setPen(QPen(faint, 1));
  painter.setBrush(Qt::NoBrush);
  for (const Eigen::Vector2d& point : section_->others)
    if (const QPointF at = toScreen(point); seen.contains(at)) painter.drawEllipse(at, 1.5, 1.5);
  painter.setPen(Qt::NoPen);
  painter.setBrush(palette().color(QPalette::Text));
  const double size = section_->points.size() > 400 ? 1.0 : 1.5;
  for (const Eigen::Vector2d& point : section_->points)
    if (const QPointF at = toScreen(point); seen.contains(at)) painter.drawEllipse(at, size, size);
}

void CrossSectionView::paintCircles(QPainter& painter) const {
  painter.setBrush(Qt::NoBrush);
  if (proposed_) {
    painter.setPen(QPen(palette().color(QPalette::Link), 1.5, Qt::DashLine));
    const double radius = proposed_->radius * scale_;
    painter.drawEllipse(toScreen(proposed_->center), radius, radius);
  }
  const Handle lit = isBusy() ? dragged_ : hovered_;
  const QPointF center = toScreen(node_.center);
  const double radius = node_.radius * scale_;
  painter.setPen(QPen(nodeColor, lit == Handle::rim ? 3.5 : 2));
  painter.drawEllipse(center, radius, radius);
  const double arm = lit == Handle::center ? 7 : 5;
  painter.setPen(QPen(nodeColor, 2));
  painter.drawLine(center - QPointF(arm, 0), center + QPointF(arm, 0));
  painter.drawLine(center - QPointF(0, arm), center + QPointF(0, arm));
  if (!canEdit() || node_.radius == 0) return;
  painter.setPen(QPen(nodeColor, 2));
  painter.setBrush(palette().color(QPalette::Base));
  for (const QPointF& side : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
    painter.drawEllipse(center + radius * side, 3, 3);
}

/// A bar of a round length, at most a third of the width.
void CrossSectionView::paintScale(QPainter& painter) const {
  const double length = roundStep(width() / 3.0 / scale_);
  const QPointF start(8, height() - 8.5);
  const QPointF end = start + QPointF(length * scale_, 0);
  const QString text = formatLength(length, unit_, 1);
  const QFontMetrics font = painter.fontMetrics();
  QRectF place(start.x(), 0, font.horizontalAdvance(text), font.height());
  place.moveBottom(start.y() - 4);
  QColor ground = palette().color(QPalette::Base); // points may lie there
  ground.setAlphaF(0.8F);
  painter.fillRect(place.adjusted(-2, 0, 2, 2), ground);
  painter.setPen(QPen(palette().color(QPalette::Text), 1));
  painter.drawText(place, Qt::AlignLeft | Qt::AlignBottom, text);
  painter.drawLine(start, end);
  painter.drawLine(start - QPointF(0, 3), start);
  painter.drawLine(end - QPointF(0, 3), end);
}

} // namespace espalier
