#include "ui/view/attachment_overlay.h"

#include "ui/view/overlay_text.h"
#include "ui/view/palette.h"

#include <QLineF>
#include <QPolygonF>

#include <cmath>

namespace espalier {
namespace {

constexpr double lineWidth = 3;      // [logical pixels], as all below
constexpr double lineRim = 2;        // about lines, so that they stand out on the plant
constexpr double ring = 8;           // radius
constexpr double arrow = 6;          // long
constexpr double betweenArrows = 36; // of arrows

/// The part of a path that is before the eye.
QPolygonF seen(const std::vector<Eigen::Vector3d>& path, const ScreenMap& screen) {
  QPolygonF line;
  for (const Eigen::Vector3d& place : path)
    if (const auto at = screen.project(place)) line.append(QPointF(at->pixel.x(), at->pixel.y()));
  return line;
}

/// Draws each stroke twice: its rim in the color of text, then itself.
class RimmedPen {
public:
  RimmedPen(QPainter& painter, const Color& color, const Color& rimColor)
      : painter_(painter), color_(color), rimColor_(rimColor) {}

  template <class Draw> void draw(const Draw& draw, Qt::PenStyle style = Qt::SolidLine) const {
    painter_.setBrush(Qt::NoBrush);
    painter_.setPen(QPen(toQt(rimColor_), lineWidth + lineRim, style, Qt::FlatCap, Qt::RoundJoin));
    draw();
    painter_.setPen(QPen(toQt(color_), lineWidth, style, Qt::FlatCap, Qt::RoundJoin));
    draw();
  }

private:
  QPainter& painter_;
  Color color_;
  Color rimColor_;
};

/// Open arrow heads along a line, in its direction.
std::vector<QPolygonF> arrowsAlong(const QPolygonF& line) {
  std::vector<QPolygonF> arrows;
  double next = betweenArrows / 2; // along the line
  double passed = 0;
  for (qsizetype i = 1; i < line.size(); ++i) {
    const QLineF part(line[i - 1], line[i]);
    for (; part.length() > 0 && next < passed + part.length(); next += betweenArrows) {
      const QPointF along = (part.p2() - part.p1()) / part.length();
      const QPointF across(-along.y(), along.x());
      const QPointF tip = part.pointAt((next - passed) / part.length()) + arrow / 2 * along;
      arrows.push_back(
          {{tip - arrow * along + arrow * across, tip, tip - arrow * along - arrow * across}});
    }
    passed += part.length();
  }
  return arrows;
}

} // namespace

void paintAttachment(QPainter& painter, const ShownAttachment& attachment, const ScreenMap& screen,
                     bool dark) {
  const Palette colors = palette(dark);
  const RimmedPen pen(painter, attachment.color, colors.text);
  const QPolygonF wrong = seen(attachment.wrong, screen);
  const QPolygonF right = seen(attachment.right, screen);
  if (wrong.size() > 1) {
    pen.draw([&] { painter.drawPolyline(wrong); }, Qt::DotLine);
    const QPointF at = wrong.back();
    pen.draw([&] {
      painter.drawLine(at + QPointF(-ring, -ring), at + QPointF(ring, ring));
      painter.drawLine(at + QPointF(-ring, ring), at + QPointF(ring, -ring));
    });
  }
  if (right.size() > 1) {
    pen.draw([&] {
      painter.drawPolyline(right);
      for (const QPolygonF& each : arrowsAlong(right))
        painter.drawPolyline(each);
    });
    pen.draw([&] { painter.drawEllipse(right.back(), ring, ring); });
  }
  constexpr double room = 28; // for a label beside the other
  const bool isApart = wrong.size() < 2 || right.size() < 2 ||
                       std::abs(wrong.back().y() - right.back().y()) > room ||
                       std::abs(wrong.back().x() - right.back().x()) > 5 * room;
  const QPointF beside(ring, 0);
  if (wrong.size() > 1 && isApart)
    paintLabel(painter, wrong.back() + beside, attachment.wrongLabel, colors);
  if (right.size() > 1) paintLabel(painter, right.back() + beside, attachment.rightLabel, colors);
}

} // namespace espalier
