#include "ui/view/ghost_overlay.h"

#include "ui/view/overlay_text.h"
#include "ui/view/palette.h"

#include <QFont>
#include <QLineF>
#include <QPolygonF>
#include <QRectF>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace espalier {
namespace {

constexpr double ghostWidth = 4; // [logical pixels], as all below
constexpr double ghostRim = 3;   // about lines
constexpr double dot = 4;        // across
constexpr double disk = GhostNumber::radius;

std::vector<QPolygonF> seenLines(const ShownGhost& ghost, const ScreenMap& screen) {
  std::vector<QPolygonF> lines;
  for (const std::vector<Eigen::Vector3d>& line : ghost.lines) {
    if (line.size() < 2) continue; // a dot
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

double distanceOf(const QPointF& at, const QPolygonF& line) {
  double least = std::numeric_limits<double>::infinity();
  for (qsizetype i = 1; i < line.size(); ++i) {
    const QPointF span = line[i] - line[i - 1];
    const double squared = QPointF::dotProduct(span, span);
    const double part =
        squared > 0 ? std::clamp(QPointF::dotProduct(at - line[i - 1], span) / squared, 0.0, 1.0)
                    : 0;
    least = std::min(least, QLineF(at, line[i - 1] + part * span).length());
  }
  return least;
}

/// Finds places for numbers beside what they name, where they cover neither a line nor each other.
class NumberPlaces {
public:
  NumberPlaces(const std::vector<std::vector<QPolygonF>>& lines, const QSizeF& screen)
      : lines_(lines), inside_(QRectF(QPointF(), screen).adjusted(disk, disk, -disk, -disk)) {}

  /// Beside one of some places of a ghost: where it covers least, and stands nearest.
  QPointF beside(const std::vector<QPointF>& named, std::size_t own) {
    QPointF best = named.front();
    double least = std::numeric_limits<double>::infinity();
    for (const double away : {disk + 8, 2 * disk + 8, 3 * disk + 8})
      for (const QPointF& of : named)
        for (int turn = 0; turn < directions; ++turn) {
          const double angle = 2 * std::numbers::pi * turn / directions;
          const QPointF at = of + away * QPointF(std::cos(angle), std::sin(angle));
          const double worse = covered(at) + 0.02 * away + (isNearestTo(at, own) ? 0 : 1);
          if (worse >= least) continue;
          least = worse;
          best = at;
        }
    taken_.push_back(best);
    return best;
  }

private:
  static constexpr int directions = 16;

  /// To stand off the screen is worst, then on another number, then on lines.
  [[nodiscard]] double covered(const QPointF& at) const {
    double sum = inside_.contains(at) ? 0 : 20;
    for (const QPointF& other : taken_)
      sum += 10 * share(2 * disk + 4 - QLineF(at, other).length());
    for (const std::vector<QPolygonF>& ghost : lines_)
      for (const QPolygonF& line : ghost)
        sum += 2 * share(disk + ghostWidth - distanceOf(at, line));
    return sum;
  }
  static double share(double overlap) { return std::clamp(overlap / disk, 0.0, 1.0); }

  /// Whether no line of another is nearer.
  [[nodiscard]] bool isNearestTo(const QPointF& at, std::size_t own) const {
    const auto distance = [&](const std::vector<QPolygonF>& ghost) {
      double least = std::numeric_limits<double>::infinity();
      for (const QPolygonF& line : ghost)
        least = std::min(least, distanceOf(at, line));
      return least;
    };
    const double ofOwn = distance(lines_[own]);
    for (std::size_t i = 0; i < lines_.size(); ++i)
      if (i != own && distance(lines_[i]) < ofOwn) return false;
    return true;
  }

  const std::vector<std::vector<QPolygonF>>& lines_; // of each ghost
  QRectF inside_;
  std::vector<QPointF> taken_;
};

/// At the end of what would go.
std::vector<QPolygonF> crossAt(const QPointF& at) {
  constexpr double arm = 9;
  return {QPolygonF({at + QPointF(-arm, -arm), at + QPointF(arm, arm)}),
          QPolygonF({at + QPointF(-arm, arm), at + QPointF(arm, -arm)})};
}

void paintCross(QPainter& painter, const QPointF& at, const Color& color, const Palette& colors) {
  for (const QPen& pen :
       {QPen(toQt(colors.outline, 200), ghostWidth + ghostRim, Qt::SolidLine, Qt::RoundCap),
        QPen(toQt(color), ghostWidth, Qt::SolidLine, Qt::RoundCap)}) {
    painter.setPen(pen);
    for (const QPolygonF& line : crossAt(at))
      painter.drawPolyline(line);
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
  default: // 4, and none
    return colors.contracted;
  }
}

std::vector<GhostNumber> numbersOf(const std::vector<ShownGhost>& ghosts, const ScreenMap& screen) {
  std::vector<std::vector<QPolygonF>> all;
  all.reserve(ghosts.size());
  for (const ShownGhost& ghost : ghosts) {
    all.push_back(seenLines(ghost, screen));
    if (ghost.look != ShownGhost::Look::removed || all.back().empty()) continue;
    all.back() = crossAt(all.back().front().back()); // all that is drawn of it
  }
  NumberPlaces places(all, QSizeF(screen.size().x(), screen.size().y()));
  std::vector<GhostNumber> numbers;
  for (std::size_t i = 0; i < ghosts.size(); ++i) {
    if (ghosts[i].number == 0 || all[i].empty()) continue;
    const QPolygonF& line = *std::ranges::max_element(all[i], {}, lengthOf);
    std::vector<QPointF> named;
    if (ghosts[i].look == ShownGhost::Look::removed)
      named = {along(all[i].front(), 0.5)}; // the middle of its cross
    else
      for (const double share : {0.5, 0.65, 0.35, 0.8, 0.2, 1.0})
        named.push_back(along(line, share));
    const QPointF at = places.beside(named, i);
    const QPointF of = *std::ranges::min_element(
        named, {}, [&](const QPointF& place) { return QLineF(at, place).length(); });
    numbers.push_back({ghosts[i].number, at, of});
  }
  return numbers;
}

void paintGhosts(QPainter& painter, const std::vector<ShownGhost>& ghosts, const ScreenMap& screen,
                 bool dark) {
  const Palette colors = palette(dark);
  painter.setBrush(Qt::NoBrush);
  for (const QPen& pen :
       {QPen(toQt(colors.outline, 200), dot + ghostRim, Qt::SolidLine, Qt::RoundCap),
        QPen(toQt(colors.selected), dot, Qt::SolidLine, Qt::RoundCap)}) {
    painter.setPen(pen);
    for (const ShownGhost& ghost : ghosts)
      painter.drawPoints(seenDots(ghost, screen));
  }
  const std::vector<GhostNumber> numbers = numbersOf(ghosts, screen);
  for (const GhostNumber& number : numbers)
    for (const QPen& pen : {QPen(toQt(colors.outline, 200), 2 + ghostRim),
                            QPen(toQt(colorOfGhost(number.number, dark)), 2)}) {
      painter.setPen(pen); // to what it names
      painter.drawLine(number.at, number.of);
    }
  struct Stroke {
    QPolygonF line;
    ShownGhost::Look look;
    Color color;
  };
  std::vector<Stroke> strokes;
  for (const ShownGhost& ghost : ghosts)
    for (QPolygonF& line : seenLines(ghost, screen))
      strokes.push_back({std::move(line), ghost.look, colorOfGhost(ghost.number, dark)});
  std::ranges::stable_sort(strokes, std::greater(),
                           [](const Stroke& stroke) { return lengthOf(stroke.line); });
  for (const auto& [line, look, color] : strokes) {
    if (look == ShownGhost::Look::removed) continue;
    painter.setPen(QPen(toQt(colors.outline, 200), ghostWidth + ghostRim, Qt::SolidLine,
                        Qt::FlatCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    painter.setPen(QPen(toQt(color), ghostWidth, styleOf(look), Qt::FlatCap, Qt::RoundJoin));
    painter.drawPolyline(line);
  }
  for (const auto& [line, look, color] : strokes)
    if (look == ShownGhost::Look::removed) paintCross(painter, line.back(), color, colors);
  for (const GhostNumber& number : numbers) {
    painter.setPen(QPen(toQt(colors.outline), 2));
    painter.setBrush(toQt(colorOfGhost(number.number, dark)));
    painter.drawEllipse(number.at, disk, disk);
    QFont font = painter.font();
    const QFont before = font;
    font.setBold(true);
    painter.setFont(font);
    painter.setPen(Qt::white);
    painter.drawText(QRectF(number.at - QPointF(disk, disk), QSizeF(2 * disk, 2 * disk)),
                     Qt::AlignCenter, QString::number(number.number));
    painter.setFont(before);
  }
}

} // namespace espalier
