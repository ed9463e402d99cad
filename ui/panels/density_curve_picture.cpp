// How a density curve is painted.
#include "ui/document/number_scale.h"
#include "ui/panels/density_curve.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>

namespace espalier {
namespace {

/// The path of a curve as it is on the screen.
template <class Place> QPainterPath pathOf(const DensityCurve::Curve& curve, const Place& place) {
  constexpr int pieces = 64;
  QPainterPath path(place(0, curve.radiusAt(0)));
  for (int i = 1; i <= pieces; ++i) {
    const double density = static_cast<double>(i) / pieces;
    path.lineTo(place(density, curve.radiusAt(density)));
  }
  return path;
}

} // namespace

void DensityCurve::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QFont small = font();
  small.setPixelSize(11);
  painter.setFont(small);
  QPainterPath frame;
  frame.addRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
  painter.fillPath(frame, palette().color(QPalette::Base));
  painter.setPen(palette().color(hasFocus() ? QPalette::Link : QPalette::Mid));
  painter.drawPath(frame);
  paintDensities(painter);
  paintAxes(painter);
  paintCurve(painter);
  paintHandles(painter);
}

void DensityCurve::paintDensities(QPainter& painter) const {
  if (densities_.isEmpty()) return;
  const QRectF box = inner();
  const auto most = static_cast<double>(*std::ranges::max_element(densities_.counts));
  if (most == 0) return;
  QColor pale = palette().color(QPalette::Text);
  pale.setAlphaF(0.16F);
  painter.setRenderHint(QPainter::Antialiasing, false); // bars join without seams
  const double width = box.width() / static_cast<double>(densities_.counts.size());
  for (std::size_t i = 0; i < densities_.counts.size(); ++i) {
    if (densities_.counts[i] == 0) continue;
    const double height =
        std::max(1.0, box.height() * static_cast<double>(densities_.counts[i]) / most);
    painter.fillRect(
        QRectF(box.left() + width * static_cast<double>(i), box.bottom() - height, width, height),
        pale);
  }
  painter.setRenderHint(QPainter::Antialiasing);
}

/// Radii in the unit on the left, in spacings on the right; the density below.
void DensityCurve::paintAxes(QPainter& painter) const {
  const QRectF box = inner();
  const QColor quiet = palette().color(QPalette::PlaceholderText);
  painter.setPen(quiet);
  painter.drawText(QRectF(4, 4, width() / 2.0, 16), Qt::AlignLeft | Qt::AlignVCenter,
                   unit_.isEmpty() ? tr("radius") : unit_);
  painter.drawText(QRectF(width() / 2.0, 4, width() / 2.0 - 4, 16),
                   Qt::AlignRight | Qt::AlignVCenter, tr("spacings"));
  painter.drawText(QRectF(box.left() - 8, box.bottom() + 3, box.width() + 16, 16),
                   Qt::AlignLeft | Qt::AlignVCenter, tr("thinnest"));
  painter.drawText(QRectF(box.left() - 8, box.bottom() + 3, box.width() + 16, 16),
                   Qt::AlignRight | Qt::AlignVCenter, tr("densest"));
  const double step = roundStep(top_ / 3);
  for (const double radius : multiplesOf(step, 0, top_)) {
    const double y = placeOf(0, radius).y();
    painter.setPen(QPen(palette().color(QPalette::Mid), 1));
    painter.drawLine(QPointF(box.left(), y), QPointF(box.right(), y));
    painter.setPen(quiet);
    painter.drawText(QRectF(0, y - 8, box.left() - 6, 16), Qt::AlignRight | Qt::AlignVCenter,
                     numberAtStep(radius, step));
  }
  const double spacingStep = roundStep(top_ / spacing_ / 3);
  for (const double spacings : multiplesOf(spacingStep, 0, top_ / spacing_)) {
    const double y = placeOf(0, spacings * spacing_).y();
    painter.setPen(QPen(palette().color(QPalette::Mid), 1));
    painter.drawLine(QPointF(box.right(), y), QPointF(box.right() + 3, y));
    painter.setPen(quiet);
    painter.drawText(QRectF(box.right() + 6, y - 8, width() - box.right() - 6, 16),
                     Qt::AlignLeft | Qt::AlignVCenter, numberAtStep(spacings, spacingStep));
  }
}

/// The default is dashed behind the curve where this is another.
void DensityCurve::paintCurve(QPainter& painter) const {
  const auto place = [this](double density, double radius) { return placeOf(density, radius); };
  painter.save();
  painter.setClipRect(inner().adjusted(-2, -2, 2, 2));
  painter.setBrush(Qt::NoBrush);
  if (default_ != curve_) {
    painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 1, Qt::DashLine));
    painter.drawPath(pathOf(default_, place));
  }
  painter.setPen(QPen(palette().color(QPalette::Link), 2));
  painter.drawPath(pathOf(curve_, place));
  painter.restore();
}

/// The handle that is dragged, or moved by keys, shows its value.
void DensityCurve::paintHandles(QPainter& painter) const {
  for (const Handle handle : handles) {
    const bool isCurrent = handle == current_ && (drag_ || hasFocus());
    const double size = handle == hovered_ || isCurrent ? 6 : 4.5;
    painter.setPen(QPen(palette().color(QPalette::Link), 2));
    painter.setBrush(palette().color(isCurrent ? QPalette::Link : QPalette::Base));
    painter.drawEllipse(placeOf(handle), size, size);
  }
  painter.setBrush(Qt::NoBrush);
  if (!drag_ && !hasFocus()) return;
  const QString text = textOf(current_);
  const QSizeF size(painter.fontMetrics().horizontalAdvance(text) + 8, 16);
  const QPointF place = placeOf(current_);
  QRectF label(QPointF(place.x() - size.width() / 2, place.y() - size.height() - 9), size);
  if (label.top() < 2) label.moveTop(place.y() + 9);
  label.moveLeft(std::clamp(label.left(), 2.0, std::max(2.0, width() - 2 - label.width())));
  QColor ground = palette().color(QPalette::Base); // the curve may be there
  ground.setAlphaF(0.85F);
  painter.fillRect(label, ground);
  painter.setPen(palette().color(QPalette::Text));
  painter.drawText(label, Qt::AlignCenter, text);
}

} // namespace espalier
