#include "ui/view/overlay_text.h"

namespace espalier {

void drawText(QPainter& painter, const QRectF& box, int alignment, const QString& text,
              const Palette& colors) {
  painter.setPen(toQt(colors.backgroundBottom, 170));
  for (const QPointF& shift : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)})
    painter.drawText(box.translated(shift), alignment, text);
  painter.setPen(toQt(colors.text));
  painter.drawText(box, alignment, text);
}

void paintVeil(QPainter& painter, const QRectF& box, const Color& background) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(toQt(background, 190));
  painter.drawRoundedRect(box, 6, 6);
}

void paintLabel(QPainter& painter, const QPointF& at, const QString& label, const Palette& colors) {
  const QFontMetricsF font(painter.font(), painter.device());
  const QSizeF size(font.horizontalAdvance(label) + 12, font.height() + 6);
  QRectF box(at + QPointF(10, -size.height() / 2), size);
  const QRectF shown = QRectF(painter.window()).adjusted(4, 4, -4, -4);
  if (box.right() > shown.right()) box.moveRight(at.x() - 10);
  box.moveTop(std::clamp(box.top(), shown.top(), std::max(shown.top(), shown.bottom() - 24)));
  paintVeil(painter, box, colors.backgroundTop);
  drawText(painter, box, Qt::AlignCenter, label, colors);
}

std::optional<QPointF> pixelOf(const ScreenMap& screen, const Eigen::Vector3d& place) {
  const auto found = screen.project(place);
  if (!found) return std::nullopt;
  return QPointF(found->pixel.x(), found->pixel.y());
}

} // namespace espalier
