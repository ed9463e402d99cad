#include "ui/view/overlay_of_tools.h"

#include "ui/view/overlay_text.h"

#include <QCoreApplication>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

/// Beside a line in the accent, so that it stands out from points of its color.
QPen haloOf(double width, const Color& outline) {
  return {toQt(outline, 150), width + 4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
}

/// All lines as one path: where they cross, they are no darker.
QPainterPath pathOf(const Preview& preview, const ScreenMap& screen) {
  QPainterPath path;
  for (const std::vector<Eigen::Vector3d>& line : preview.lines) {
    std::optional<QPointF> last;
    for (const Eigen::Vector3d& place : line) {
      const std::optional<QPointF> at = pixelOf(screen, place);
      if (at && last)
        path.lineTo(*at);
      else if (at)
        path.moveTo(*at);
      last = at;
    }
  }
  return path;
}

/// From the middle of the view to a place, which may be behind the eye.
QPointF directionTo(const Eigen::Vector3d& place, const ScreenMap& screen) {
  const QPointF middle(screen.size().x() / 2, screen.size().y() / 2);
  if (const auto at = pixelOf(screen, place)) return *at - middle;
  const Camera& camera = screen.camera();
  const Eigen::Vector3d from = place - screen.eye();
  return {from.dot(camera.right()), -from.dot(camera.up())};
}

/// An arrow at the rim of the view that leads to what lies beyond it.
void paintRimArrow(QPainter& painter, const Eigen::Vector3d& place, const ScreenMap& screen,
                   const Palette& colors) {
  constexpr double inset = 8; // of its tip [px]
  const QSizeF size(screen.size().x(), screen.size().y());
  const auto at = pixelOf(screen, place);
  if (at && QRectF(QPointF(), size).contains(*at)) return;
  const QPointF toward = directionTo(place, screen);
  const double length = std::hypot(toward.x(), toward.y());
  if (!(length > 0)) return;
  const QPointF along = toward / length;
  const QPointF across(-along.y(), along.x());
  const double toSide = (size.width() / 2 - inset) / std::max(std::abs(along.x()), 1e-9);
  const double toEdge = (size.height() / 2 - inset) / std::max(std::abs(along.y()), 1e-9);
  const QPointF tip =
      QPointF(size.width() / 2, size.height() / 2) + std::min(toSide, toEdge) * along;
  const QPolygonF arrow({tip, tip - 18 * along + 9 * across, tip - 18 * along - 9 * across});
  painter.setPen(QPen(toQt(colors.outline, 200), 2, Qt::SolidLine, Qt::SquareCap, Qt::RoundJoin));
  painter.setBrush(toQt(colors.contracted));
  painter.drawPolygon(arrow);
}

} // namespace

void paintBand(QPainter& painter, const QPolygonF& band, bool dark) {
  if (band.size() < 2) return;
  const Color accent = palette(dark).contracted;
  painter.setPen(QPen(toQt(accent), 1, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(band.isClosed() ? QBrush(toQt(accent, 30)) : QBrush(Qt::NoBrush));
  if (band.isClosed()) {
    painter.drawPolygon(band.translated(0.5, 0.5), Qt::WindingFill); // on pixels, not between them
  } else {
    painter.setPen(haloOf(2, palette(dark).outline));
    painter.drawPolyline(band);
    painter.setPen(QPen(toQt(accent), 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(band);
  }
}

void paintPreview(QPainter& painter, const Preview& preview, const ScreenMap& screen, bool dark) {
  if (preview.isEmpty()) return;
  const Palette colors = palette(dark);
  painter.setBrush(Qt::NoBrush);
  const QPainterPath lines = pathOf(preview, screen);
  // Seen from afar, the nodes would hide the lines, and the plant.
  const double apart =
      lines.length() / static_cast<double>(std::max<std::size_t>(preview.nodes.size(), 1));
  const bool isFar = preview.nodes.size() > 50 && apart < 16;
  const double width = isFar ? 2.5 : 4;
  painter.setPen(haloOf(width, colors.outline));
  painter.drawPath(lines);
  painter.setPen(QPen(toQt(colors.contracted, isFar ? 220 : 170), width, Qt::SolidLine,
                      Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(lines);
  painter.setPen(QPen(toQt(colors.outline, 200), 1));
  painter.setBrush(toQt(colors.contracted, 210));
  if (!isFar)
    for (const Eigen::Vector3d& node : preview.nodes)
      if (const auto at = pixelOf(screen, node)) painter.drawEllipse(*at, 4, 4);
  for (const Eigen::Vector3d& subject : preview.subjects)
    paintRimArrow(painter, subject, screen, colors);
  if (preview.label.isEmpty()) return;
  const bool hasLine = !preview.lines.empty() && !preview.lines.back().empty();
  if (!hasLine && preview.nodes.empty()) return;
  const auto end = pixelOf(screen, hasLine ? preview.lines.back().back() : preview.nodes.back());
  if (end) paintLabel(painter, *end, preview.label, colors);
}

void paintRootMark(QPainter& painter, const Eigen::Vector3d& place, const ScreenMap& screen,
                   bool dark) {
  const std::optional<QPointF> at = pixelOf(screen, place);
  if (!at) return;
  const Palette colors = palette(dark);
  constexpr double half = 6; // a square, as roots are
  const QRectF square(*at - QPointF(half, half), *at + QPointF(half, half));
  painter.setBrush(toQt(colors.contracted, 90));
  painter.setPen(QPen(toQt(colors.outline, 220), 4, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter.drawRect(square);
  painter.setPen(QPen(toQt(colors.contracted), 2, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
  painter.drawRect(square);
  paintLabel(painter, *at, QCoreApplication::translate("espalier::Overlay", "root"), colors);
}

} // namespace espalier
