#include "ui/view/sight_overlay.h"

#include "ui/view/overlay_text.h"
#include "ui/view/palette.h"

#include <QCoreApplication>
#include <QPolygonF>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {
namespace {

constexpr int circleCorners = 48; // of a circle

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
    for (int i = 0; i <= circleCorners; ++i) {
      const double angle = 2 * std::numbers::pi * i / circleCorners;
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

/// What a color stands for.
struct KeyRow {
  QString name;
  Color color;
  bool isDot = false;
  bool isDashed = false;
};

struct SightKey {
  Q_DECLARE_TR_FUNCTIONS(SightKey)
};

std::vector<KeyRow> keyOf(const ShownSight& sight, const Palette& colors) {
  std::vector<KeyRow> rows = {
      {SightKey::tr("Points its new place is from"), colors.selected, true},
      {SightKey::tr("Where it goes"), colors.contracted},
      {sight.circle ? SightKey::tr("Neighbors, and the circle through them")
                    : SightKey::tr("Neighbors"),
       colors.reference},
      {SightKey::tr("Direction of the wood"), colors.text},
      {.name = SightKey::tr("Normal"), .color = colors.normal, .isDashed = true}};
  if (!sight.cones.empty()) rows.push_back({SightKey::tr("Cones of the search"), colors.branching});
  return rows;
}

QPen penOf(const Color& color, double width, bool isDashed = false) {
  QPen pen(toQt(color), width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
  if (isDashed) pen.setDashPattern({2, 1.8}); // in widths
  return pen;
}

} // namespace

void paintSight(QPainter& painter, const ShownSight& sight, const ScreenMap& screen, bool dark) {
  if (!sight.point) return;
  const Eigen::Vector3d& point = *sight.point;
  const Palette colors = palette(dark);
  SightPainter paint(painter, screen);
  painter.setPen(Qt::NoPen);
  painter.setBrush(toQt(colors.selected, 190));
  for (const Eigen::Vector3d& place : sight.ball)
    paint.dot(place, 1.5);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(toQt(colors.branching, 150), 1));
  for (const ShownSight::Cone& cone : sight.cones)
    paint.cone(cone);
  painter.setPen(penOf(colors.reference, 1.5));
  for (const Eigen::Vector3d& place : sight.neighbors)
    paint.line(point, place);
  if (sight.circle) paint.circle(sight.circle->center, sight.circle->normal, sight.circle->radius);
  painter.setPen(penOf(colors.text, 2.5));
  paint.line(point - sight.reach * sight.direction, point + sight.reach * sight.direction);
  painter.setPen(penOf(colors.normal, 2.5, true));
  paint.line(point, point + 0.6 * sight.reach * sight.normal);
  painter.setPen(penOf(colors.contracted, 2.5));
  paint.line(point, sight.moved);
  painter.setBrush(toQt(colors.contracted));
  paint.dot(sight.moved, 4);
  painter.setPen(penOf(colors.outline, 1));
  painter.setBrush(toQt(colors.text));
  paint.dot(point, 3.5);
}

void paintSightKey(QPainter& painter, const ShownSight& sight, bool dark) {
  constexpr double row = 20; // [logical pixels], as all here
  constexpr double swatch = 18;
  const Palette colors = palette(dark);
  const std::vector<KeyRow> rows = keyOf(sight, colors);
  const QFontMetricsF font(painter.font(), painter.device());
  double width = 0;
  for (const QString& line : sight.lines)
    width = std::max(width, font.horizontalAdvance(line));
  for (const KeyRow& each : rows)
    width = std::max(width, swatch + 8 + font.horizontalAdvance(each.name));
  const double height = row * static_cast<double>(sight.lines.size() + std::ssize(rows));
  paintVeil(painter, QRectF(8, 8, width + 16, height + 12), colors.backgroundTop);
  QRectF line(16, 14, width, row);
  for (const QString& text : sight.lines) {
    drawText(painter, line, Qt::AlignLeft | Qt::AlignVCenter, text, colors);
    line.translate(0, row);
  }
  for (const KeyRow& each : rows) {
    const QPointF middle(line.left() + swatch / 2, line.center().y());
    painter.setPen(each.isDot ? QPen(Qt::NoPen) : penOf(each.color, 2.5, each.isDashed));
    painter.setBrush(toQt(each.color));
    if (each.isDot)
      painter.drawEllipse(middle, 3.5, 3.5);
    else
      painter.drawLine(middle - QPointF(swatch / 2, 0), middle + QPointF(swatch / 2, 0));
    drawText(painter, line.adjusted(swatch + 8, 0, 0, 0), Qt::AlignLeft | Qt::AlignVCenter,
             each.name, colors);
    line.translate(0, row);
  }
}

} // namespace espalier
