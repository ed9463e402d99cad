#include "ui/view/ghost_overlay.h"

#include "ui/view/overlay_text.h"
#include "ui/view/palette.h"

#include <QFont>
#include <QLineF>
#include <QPolygonF>
#include <QRectF>

#include <algorithm>
#include <optional>

namespace espalier {
namespace {

constexpr double width = 4; // [logical pixels], as all below
constexpr double rim = 3;   // about lines
constexpr double dot = 4;   // across
constexpr double disk = 11; // radius, under a number

std::vector<QPolygonF> seenLines(const ShownGhost& ghost, const ScreenMap& screen) {
  std::vector<QPolygonF> lines;
  for (const std::vector<Eigen::Vector3d>& line : ghost.lines) {
    QPolygonF seen;
    for (const Eigen::Vector3d& place : line)
      if (const auto at = pixelOf(screen, place)) seen.append(*at);
    if (seen.size() > 1) lines.push_back(std::move(seen));
  }
  return lines;
}

QPolygonF seenDots(const ShownGhost& ghost, const ScreenMap& screen) {
  QPolygonF dots;
  for (const std::vector<Eigen::Vector3d>& line : ghost.lines)
    if (const auto at = line.size() == 1 ? pixelOf(screen, line.front()) : std::nullopt)
      dots.append(*at);
  return dots;
}

Qt::PenStyle styleOf(ShownGhost::Look look) {
  switch (look) {
  case ShownGhost::Look::present:
    return Qt::SolidLine;
  case ShownGhost::Look::proposed:
    return Qt::DashLine;
  case ShownGhost::Look::removed: // of its cross
    break;
  }
  return Qt::SolidLine;
}

double lengthOf(const QPolygonF& line) {
  double length = 0;
  for (qsizetype i = 1; i < line.size(); ++i)
    length += QLineF(line[i - 1], line[i]).length();
  return length;
}

/// A place at a share of the length of a line.
QPointF along(const QPolygonF& line, double share) {
  double left = share * lengthOf(line);
  for (qsizetype i = 1; i < line.size(); ++i) {
    const QLineF part(line[i - 1], line[i]);
    if (part.length() > 0 && left <= part.length()) return part.pointAt(left / part.length());
    left -= part.length();
  }
  return line.back();
}

/// Where a number stands: on its longest line, at the first of some shares where no other stands.
std::optional<QPointF> labelPlace(const std::vector<QPolygonF>& lines,
                                  const std::vector<QPointF>& taken) {
  if (lines.empty()) return std::nullopt;
  const QPolygonF& line = *std::ranges::max_element(lines, {}, lengthOf);
  for (const double share : {0.5, 0.65, 0.35, 0.8, 0.2, 1.0})
    if (const QPointF at = along(line, share); std::ranges::all_of(
            taken, [&](const QPointF& other) { return QLineF(at, other).length() > 2.2 * disk; }))
      return at;
  return along(line, 0.5) + QPointF(2.5 * disk * static_cast<double>(taken.size()), 0);
}

/// At the end of what would go.
void paintCross(QPainter& painter, const QPointF& at, const Color& color, const Palette& colors) {
  constexpr double arm = 9;
  for (const QPen& pen : {QPen(toQt(colors.outline, 200), width + rim, Qt::SolidLine, Qt::RoundCap),
                          QPen(toQt(color), width, Qt::SolidLine, Qt::RoundCap)}) {
    painter.setPen(pen);
    painter.drawLine(at + QPointF(-arm, -arm), at + QPointF(arm, arm));
    painter.drawLine(at + QPointF(-arm, arm), at + QPointF(arm, -arm));
  }
}

} // namespace

Color colorOfGhost(int number, bool dark) {
  const Palette colors = palette(dark);
  switch (number) {
  case 1:
    return colors.reference;
  case 2:
    return colors.branching;
  case 3:
    return colors.normal;
  case 4:
    return colors.selected;
  default:
    return colors.contracted;
  }
}

void paintGhosts(QPainter& painter, const std::vector<ShownGhost>& ghosts, const ScreenMap& screen,
                 bool dark) {
  const Palette colors = palette(dark);
  std::vector<std::vector<QPolygonF>> all;
  all.reserve(ghosts.size());
  for (const ShownGhost& ghost : ghosts)
    all.push_back(seenLines(ghost, screen));
  painter.setBrush(Qt::NoBrush);
  for (const QPen& pen : {QPen(toQt(colors.outline, 200), dot + rim, Qt::SolidLine, Qt::RoundCap),
                          QPen(toQt(colors.selected), dot, Qt::SolidLine, Qt::RoundCap)}) {
    painter.setPen(pen);
    for (const ShownGhost& ghost : ghosts)
      painter.drawPoints(seenDots(ghost, screen));
  }
  for (std::size_t i = 0; i < ghosts.size(); ++i) {
    const Color color = colorOfGhost(ghosts[i].number, dark);
    if (ghosts[i].look == ShownGhost::Look::removed) {
      for (const QPolygonF& line : all[i])
        paintCross(painter, line.back(), color, colors);
      continue;
    }
    for (const QPolygonF& line : all[i]) {
      painter.setPen(
          QPen(toQt(colors.outline, 200), width + rim, Qt::SolidLine, Qt::FlatCap, Qt::RoundJoin));
      painter.drawPolyline(line);
      painter.setPen(QPen(toQt(color), width, styleOf(ghosts[i].look), Qt::FlatCap, Qt::RoundJoin));
      painter.drawPolyline(line);
    }
  }
  std::vector<QPointF> taken;
  for (std::size_t i = 0; i < ghosts.size(); ++i) {
    if (ghosts[i].number == 0) continue;
    std::optional<QPointF> at = labelPlace(all[i], taken);
    if (at && ghosts[i].look == ShownGhost::Look::removed)
      at = all[i].front().back() + QPointF(2.2 * disk, 0); // beside its cross
    if (!at) continue;
    taken.push_back(*at);
    painter.setPen(QPen(toQt(colors.outline), 2));
    painter.setBrush(toQt(colorOfGhost(ghosts[i].number, dark)));
    painter.drawEllipse(*at, disk, disk);
    QFont font = painter.font();
    const QFont before = font;
    font.setBold(true);
    painter.setFont(font);
    painter.setPen(Qt::white);
    painter.drawText(QRectF(at->x() - disk, at->y() - disk, 2 * disk, 2 * disk), Qt::AlignCenter,
                     QString::number(ghosts[i].number));
    painter.setFont(before);
  }
}

} // namespace espalier
