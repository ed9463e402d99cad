#include "ui/view/divider.h"

#include "ui/view/overlay_text.h"
#include "ui/view/palette.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>

namespace espalier {
namespace {

constexpr int lineReach = 8;       // [pixels] on either side of the line
constexpr double keyStep = 0.02;   // of an arrow key
constexpr double leastSide = 0.03; // of the view that is left to each side

} // namespace

Divider::Divider(QWidget* view) : QWidget(view) {
  setObjectName("divider");
  setAccessibleName(tr("Divider between two states of the plant"));
  setToolTip(tr("Drag to show more of one or the other; arrow keys move it as well"));
  setCursor(Qt::SplitHCursor);
  setFocusPolicy(Qt::TabFocus);
}

void Divider::place(double across, bool dark) {
  across_ = across;
  dark_ = dark;
  const QWidget* view = parentWidget();
  const int x = static_cast<int>(across * view->width());
  setGeometry(x - lineReach, 0, 2 * lineReach + 1, view->height());
  raise();
  update();
}

void Divider::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const Palette colors = espalier::palette(dark_);
  const QColor line = hasFocus() ? toQt(colors.contracted) : toQt(colors.text);
  const double x = lineReach + 0.5;
  painter.setPen(QPen(toQt(colors.backgroundBottom, 200), 4));
  painter.drawLine(QPointF(x, 0), QPointF(x, height()));
  painter.setPen(QPen(line, 1.5));
  painter.drawLine(QPointF(x, 0), QPointF(x, height()));
  const QRectF grip(x - 5, height() / 2.0 - 18, 10, 36);
  painter.setBrush(toQt(colors.backgroundTop));
  painter.drawRoundedRect(grip, 4, 4);
  for (const double dx : {-1.5, 1.5})
    painter.drawLine(QPointF(x + dx, grip.top() + 10), QPointF(x + dx, grip.bottom() - 10));
}

void Divider::mousePressEvent(QMouseEvent* event) {
  event->accept(); // else the view would turn
}

void Divider::mouseMoveEvent(QMouseEvent* event) {
  if (event->buttons().testFlag(Qt::LeftButton))
    ask((geometry().left() + event->position().x()) / parentWidget()->width());
}

void Divider::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Left)
    ask(across_ - keyStep);
  else if (event->key() == Qt::Key_Right)
    ask(across_ + keyStep);
  else
    QWidget::keyPressEvent(event);
}

void Divider::ask(double across) {
  emit moveAsked(std::clamp(across, leastSide, 1 - leastSide));
}

void Divider::enterEvent(QEnterEvent* event) {
  emit entered();
  QWidget::enterEvent(event);
}

void Divider::focusInEvent(QFocusEvent* event) {
  update();
  QWidget::focusInEvent(event);
}

void Divider::focusOutEvent(QFocusEvent* event) {
  update();
  QWidget::focusOutEvent(event);
}

} // namespace espalier
