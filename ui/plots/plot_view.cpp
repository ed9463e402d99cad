#include "ui/plots/plot_view.h"

#include <QKeyEvent>
#include <QMouseEvent>

#include <algorithm>

namespace espalier {

PlotView::PlotView(QWidget* parent) : QWidget(parent) {
  setObjectName("tolerance_plot");
  setAccessibleName(tr("Agreement over the tolerance"));
  setToolTip(tr("Precision, recall and F over the tolerance; drag to choose one"));
  setMinimumSize(220, 110);
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::PointingHandCursor);
}

void PlotView::show(const TolerancePlot& plot) {
  plot_ = plot;
  update();
}

void PlotView::setStale(bool isStale) {
  isStale_ = isStale;
  update();
}

void PlotView::setDark(bool isDark) {
  isDark_ = isDark;
  update();
}

void PlotView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  if (isStale_) painter.setOpacity(0.4);
  plot_.paint(painter, rect(), plotColors(isDark_));
  painter.setOpacity(1);
  if (!hasFocus()) return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void PlotView::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) choose(event->position());
}

void PlotView::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons().testFlag(Qt::LeftButton)) choose(event->position());
}

void PlotView::keyPressEvent(QKeyEvent* event) {
  const int direction = event->key() == Qt::Key_Right ? 1 : event->key() == Qt::Key_Left ? -1 : 0;
  if (direction == 0 || plot_.curve.size() < 2 || !plot_.chosen)
    return QWidget::keyPressEvent(event);
  const double step = plot_.curve[1].distance - plot_.curve[0].distance;
  const double chosen = plot_.chosen->distance + direction * step;
  if (chosen <= 0 || chosen > plot_.curve.back().distance) return;
  plot_.chosen = plot_.scoreAt(chosen); // until it is measured
  update();
  emit toleranceChosen(chosen);
}

void PlotView::choose(const QPointF& place) {
  const std::optional<double> under = plot_.toleranceAt(place, rect());
  if (!under) return;
  const double least = (plot_.curve.back().distance - plot_.curve.front().distance) / 100;
  const double tolerance = std::max(*under, least);
  plot_.chosen = plot_.scoreAt(tolerance); // until it is measured
  update();
  emit toleranceChosen(tolerance);
}

} // namespace espalier
