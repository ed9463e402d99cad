#include "ui/panels/density_curve.h"

#include "ui/document/number_scale.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr double curveGrip = 10;      // how near the pointer takes a handle [px]
constexpr double curveFineness = 0.1; // of a move of the mouse or a key, with Shift
constexpr double exponentStep = 1.1;  // a key multiplies by it
constexpr double middle = 0.5;        // density where the curve is bent

QString withUnit(const QString& number, const QString& unit) {
  return unit.isEmpty() ? number : number + QChar(0x202f) + unit;
}

/// To three digits, as people write it.
QString exponentText(double exponent) {
  return QString::number(exponent, 'g', 3);
}

} // namespace

double DensityCurve::Curve::radiusAt(double density) const {
  return least + (most - least) * std::pow(density, exponent);
}

DensityCurve::DensityCurve(QWidget* parent) : QWidget(parent) {
  setObjectName("density_curve");
  setAccessibleName(tr("Radius over the density of the points"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  describe();
}

void DensityCurve::setCurve(const Curve& curve) {
  if (curve_ == curve) return;
  curve_ = curve;
  if (!drag_) refreshScale();
  describe();
  update();
}

void DensityCurve::setDensities(const std::vector<float>& densities) {
  densities_ = binned(densities, std::pair(0.0, 1.0));
  update();
}

void DensityCurve::setLimits(const Curve& lowest, const Curve& highest, const QString& unit,
                             double spacing) {
  lowest_ = lowest;
  highest_ = highest;
  unit_ = unit;
  spacing_ = spacing;
  drag_.reset();
  refreshScale();
  describe();
  update();
}

void DensityCurve::setDefault(const Curve& curve) {
  default_ = curve;
  refreshScale();
  update();
}

/// The axis has room above the curve and the default, so that both can be seen to move.
void DensityCurve::refreshScale() {
  constexpr double room = 1.35;
  const double most =
      std::max({curve_.least, curve_.most, default_.least, default_.most, lowest_.least});
  top_ = most > 0 ? room * most : 1;
}

QRectF DensityCurve::inner() const {
  return QRectF(rect()).adjusted(36, 22, -30, -20);
}

QPointF DensityCurve::placeOf(double density, double radius) const {
  const QRectF box = inner();
  return {box.left() + density * box.width(), box.bottom() - radius / top_ * box.height()};
}

double DensityCurve::radiusAt(double y) const {
  const QRectF box = inner();
  return top_ * (box.bottom() - y) / std::max(box.height(), 1.0);
}

QPointF DensityCurve::placeOf(Handle handle) const {
  const double density = handle == Handle::least ? 0 : handle == Handle::most ? 1 : middle;
  QPointF place = placeOf(density, curve_.radiusAt(density));
  place.setY(std::clamp(place.y(), inner().top(), inner().bottom())); // dragged out it stays seen
  return place;
}

std::optional<DensityCurve::Handle> DensityCurve::handleAt(const QPointF& place) const {
  std::optional<Handle> nearest;
  double least = curveGrip;
  for (const Handle handle : handles) {
    const QPointF d = place - placeOf(handle);
    if (std::hypot(d.x(), d.y()) > least) continue;
    least = std::hypot(d.x(), d.y());
    nearest = handle;
  }
  return nearest;
}

double DensityCurve::radiusStep() const {
  return roundStep(top_ / 50);
}

QString DensityCurve::textOf(double radius) const {
  const double fine = roundStep(curveFineness * radiusStep());
  return tr("%1 = %2 spacings")
      .arg(withUnit(numberAtStep(radius, fine), unit_),
           numberAtStep(radius / spacing_, roundStep(fine / spacing_)));
}

QString DensityCurve::textOf(Handle handle) const {
  if (handle == Handle::bend) return tr("Curve %1").arg(exponentText(curve_.exponent));
  return handle == Handle::least ? tr("Least %1").arg(textOf(curve_.least))
                                 : tr("Greatest %1").arg(textOf(curve_.most));
}

void DensityCurve::moveTo(Handle handle, double y, bool isFine) {
  const double radius = radiusAt(y);
  if (handle == Handle::bend) {
    const double rise = curve_.most - curve_.least;
    if (rise <= 0) return; // a flat line has no bend
    const double share = std::clamp((radius - curve_.least) / rise, 1e-9, 1 - 1e-9);
    setExponent(std::log(share) / std::log(middle));
    return;
  }
  const double step =
      roundStep((isFine ? curveFineness : 1) * top_ / std::max(inner().height(), 1.0));
  setRadius(handle, std::round(radius / step) * step);
}

/// The least radius is never above the greatest.
void DensityCurve::setRadius(Handle handle, double radius) {
  Curve curve = curve_;
  if (handle == Handle::least)
    curve.least = std::clamp(radius, lowest_.least, std::max(curve.most, lowest_.least));
  else
    curve.most = std::clamp(radius, std::min(curve.least, highest_.most), highest_.most);
  set(curve);
}

void DensityCurve::setExponent(double exponent) {
  Curve curve = curve_;
  const double clamped = std::clamp(exponent, lowest_.exponent, highest_.exponent);
  curve.exponent = exponentText(clamped).toDouble(); // what is written is what is used
  set(curve);
}

void DensityCurve::step(Handle handle, int direction, bool isFine) {
  const double size = isFine ? curveFineness : 1;
  if (handle == Handle::bend) {
    setExponent(curve_.exponent * std::pow(exponentStep, -direction * size)); // up: more radius
    return;
  }
  const double radius = handle == Handle::least ? curve_.least : curve_.most;
  const double unit = size * radiusStep();
  setRadius(handle, std::round(radius / unit + direction) * unit);
}

void DensityCurve::set(const Curve& curve) {
  if (curve == curve_) return;
  setCurve(curve);
  emit changed(curve_);
}

/// For those who do not see it.
void DensityCurve::describe() {
  setAccessibleDescription(textOf(current_));
}

bool DensityCurve::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if ((key >= Qt::Key_Left && key <= Qt::Key_Down) || (drag_ && key == Qt::Key_Escape)) {
      event->accept();
      return true;
    }
  }
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    const std::optional<Handle> handle = handleAt(help->pos());
    const QString does = !handle ? tr("Radius over the density of the points: drag a handle")
                         : *handle == Handle::bend ? tr("Drag up or down to bend the curve")
                         : *handle == Handle::least
                             ? tr("Drag to set the radius where points lie thinnest")
                             : tr("Drag to set the radius where points lie densest");
    const QString rest = tr("Shift: finely. Double click: the default.");
    QToolTip::showText(help->globalPos(),
                       handle ? textOf(*handle) + '\n' + does + '\n' + rest : does, this);
    return true;
  }
  return QWidget::event(event);
}

void DensityCurve::mousePressEvent(QMouseEvent* event) {
  const std::optional<Handle> handle = handleAt(event->position());
  if (event->button() != Qt::LeftButton || !handle) return;
  current_ = *handle;
  drag_ = Drag{placeOf(*handle).y(), event->position().y(), curve_};
  describe();
  update();
}

void DensityCurve::mouseMoveEvent(QMouseEvent* event) {
  if (!drag_) {
    hovered_ = handleAt(event->position());
    setCursor(hovered_ ? Qt::SizeVerCursor : Qt::ArrowCursor);
    update();
    return;
  }
  const bool isFine = event->modifiers().testFlag(Qt::ShiftModifier);
  drag_->y += (isFine ? curveFineness : 1) * (event->position().y() - drag_->mouse);
  drag_->mouse = event->position().y();
  moveTo(current_, drag_->y, isFine);
}

void DensityCurve::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !drag_) return;
  drag_.reset();
  refreshScale();
  update();
}

void DensityCurve::mouseDoubleClickEvent(QMouseEvent* event) {
  const std::optional<Handle> handle = handleAt(event->position());
  if (event->button() != Qt::LeftButton || !handle) return;
  drag_.reset();
  Curve curve = curve_;
  if (*handle == Handle::least) curve.least = default_.least;
  if (*handle == Handle::bend) curve.exponent = default_.exponent;
  if (*handle == Handle::most) curve.most = default_.most;
  set(curve);
}

void DensityCurve::keyPressEvent(QKeyEvent* event) {
  const int key = event->key();
  if (drag_ && key == Qt::Key_Escape) {
    const Curve before = drag_->before;
    drag_.reset();
    set(before);
    return;
  }
  if (drag_ || key < Qt::Key_Left || key > Qt::Key_Down) return QWidget::keyPressEvent(event);
  const bool isUp = key == Qt::Key_Up || key == Qt::Key_Right;
  step(current_, isUp ? 1 : -1, event->modifiers().testFlag(Qt::ShiftModifier));
}

void DensityCurve::focusInEvent(QFocusEvent* event) {
  if (event->reason() == Qt::TabFocusReason) current_ = handles.front();
  if (event->reason() == Qt::BacktabFocusReason) current_ = handles.back();
  describe();
  update();
  QWidget::focusInEvent(event);
}

void DensityCurve::focusOutEvent(QFocusEvent* event) {
  drag_.reset();
  update();
  QWidget::focusOutEvent(event);
}

void DensityCurve::leaveEvent(QEvent* event) {
  hovered_.reset();
  update();
  QWidget::leaveEvent(event);
}

/// Tab goes through the handles before it leaves.
bool DensityCurve::focusNextPrevChild(bool isNext) {
  const Handle last = isNext ? handles.back() : handles.front();
  if (!hasFocus() || current_ == last) return QWidget::focusNextPrevChild(isNext);
  current_ = handles[static_cast<std::size_t>(current_) + (isNext ? 1 : -1)];
  describe();
  update();
  return true;
}

} // namespace espalier
