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

} // namespace espalier
