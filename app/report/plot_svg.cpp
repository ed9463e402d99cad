#include "app/report/plot_svg.h"

#include <QBuffer>
#include <QSvgGenerator>

namespace espalier {

QString svgOf(const ReportPlot& plot) {
  QBuffer buffer;
  buffer.open(QIODevice::WriteOnly);
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setSize(plot.size);
  generator.setViewBox(QRect(QPoint(), plot.size));
  generator.setResolution(96);
  QPainter painter(&generator);
  plot.paint(painter, QRectF(QPointF(), QSizeF(plot.size)), plotColors(false));
  painter.end();
  // Its head is that of a file of its own: what is drawn begins at the definitions.
  const QString whole = QString::fromUtf8(buffer.data());
  return QStringLiteral("<svg viewBox=\"0 0 %1 %2\" role=\"img\" aria-label=\"%3\">\n")
             .arg(plot.size.width())
             .arg(plot.size.height())
             .arg(plot.text.toHtmlEscaped()) +
         whole.mid(whole.indexOf(QLatin1String("<defs")));
}

} // namespace espalier
