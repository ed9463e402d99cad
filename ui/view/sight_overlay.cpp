#include "ui/view/sight_overlay.h"

#include "ui/view/overlay_text.h"
#include "ui/view/palette.h"

#include <QPolygonF>

#include <cmath>
#include <numbers>

namespace espalier {
namespace {

constexpr int corners = 48; // of a circle

/// Draws places and lines of the plant where they are seen.
class SightPainter {
public:
  SightPainter(QPainter& painter, const ScreenMap& screen) : painter_(painter), screen_(screen) {}

  [[nodiscard]] std::optional<QPointF> pixelOf(const Eigen::Vector3d& place) const {
    const auto at = screen_.project(place);
    return at ? std::optional(QPointF(at->pixel.x(), at->pixel.y())) : std::nullopt;
  }
  void line(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
    const auto a = pixelOf(from);
    const auto b = pixelOf(to);
    if (a && b) painter_.drawLine(*a, *b);
  }
  void dot(const Eigen::Vector3d& place, double radius) {
    if (const auto at = pixelOf(place)) painter_.drawEllipse(*at, radius, radius);
  }
  void circle(const Eigen::Vector3d& center, const Eigen::Vector3d& normal, double radius) {
    const Eigen::Vector3d across = normal.unitOrthogonal();
    const Eigen::Vector3d other = normal.cross(across);
    QPolygonF outline;
    for (int i = 0; i <= corners; ++i) {
      const double angle = 2 * std::numbers::pi * i / corners;
      const auto at =
          pixelOf(center + radius * (std::cos(angle) * across + std::sin(angle) * other));
      if (!at) return;
      outline.append(*at);
    }
    painter_.drawPolyline(outline);
  }
  /// Its rim, and where it seems to begin.
  void cone(const ShownSight::Cone& cone) {
    const double half = std::min(cone.angle / 2, 1.5);
    const Eigen::Vector3d middle = cone.apex + cone.length * std::cos(half) * cone.direction;
    const double radius = cone.length * std::sin(half);
    circle(middle, cone.direction, radius);
    const Eigen::Vector3d across = cone.direction.unitOrthogonal();
    const Eigen::Vector3d other = cone.direction.cross(across);
    for (int i = 0; i < 8; ++i) {
      const double angle = 2 * std::numbers::pi * i / 8;
      line(cone.apex, middle + radius * (std::cos(angle) * across + std::sin(angle) * other));
    }
  }

private:
  QPainter& painter_;
  const ScreenMap& screen_;
};

QPen penOf(const Color& color, double width, int alpha = 255) {
  return {toQt(color, alpha), width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin};
}

} // namespace

void paintSight(QPainter& painter, const ShownSight& sight, const ScreenMap& screen, bool dark) {
  const Palette colors = palette(dark);
  SightPainter paint(painter, screen);
  painter.setPen(Qt::NoPen);
  painter.setBrush(toQt(colors.selected, 190));
  for (const Eigen::Vector3d& place : sight.ball)
    paint.dot(place, 1.5);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(penOf(colors.branching, 1, 150));
  for (const ShownSight::Cone& cone : sight.cones)
    paint.cone(cone);
  painter.setPen(penOf(colors.reference, 1.5));
  for (const Eigen::Vector3d& place : sight.neighbors)
    paint.line(sight.point, place);
  if (sight.circle) paint.circle(sight.circle->center, sight.circle->normal, sight.circle->radius);
  painter.setPen(penOf(colors.text, 2.5));
  paint.line(sight.point - sight.reach * sight.direction,
             sight.point + sight.reach * sight.direction);
  painter.setPen(penOf(colors.hovered, 2));
  paint.line(sight.point, sight.point + 0.6 * sight.reach * sight.normal);
  painter.setPen(penOf(colors.contracted, 2.5));
  paint.line(sight.point, sight.moved);
  painter.setBrush(toQt(colors.contracted));
  paint.dot(sight.moved, 4);
  painter.setPen(penOf(colors.outline, 1));
  painter.setBrush(toQt(colors.text));
  paint.dot(sight.point, 3.5);
  if (const auto at = paint.pixelOf(sight.point); at && !sight.label.isEmpty())
    paintLabel(painter, *at, sight.label, colors);
}

} // namespace espalier
