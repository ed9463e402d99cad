#include "ui/plots/tolerance_plot.h"

#include <QCoreApplication>
#include <QPainterPath>

#include <algorithm>
#include <array>

namespace espalier {
namespace {

struct ToleranceText {
  Q_DECLARE_TR_FUNCTIONS(TolerancePlot)
};

/// What is painted where.
struct Frame {
  QRectF inner; // within the axes
  double from;  // tolerance at its left [L]
  double to;

  [[nodiscard]] QPointF at(double tolerance, double share) const {
    return {inner.left() + inner.width() * (tolerance - from) / (to - from),
            inner.bottom() - inner.height() * share};
  }
};

/// Room for numbers to the left and below, and for names to the right. pre: two scores at least
Frame frameOf(const TolerancePlot& plot, const QRectF& box) {
  return {box.adjusted(36, 8, -64, -36), plot.curve.front().distance, plot.curve.back().distance};
}

struct Line {
  double (*share)(const ToleranceScore&);
  QString name;
  QColor color;
  Qt::PenStyle style;
};

std::array<Line, 3> linesOf(const PlotColors& colors) {
  return {{{[](const ToleranceScore& score) { return score.f(); }, ToleranceText::tr("F"),
            colors.first, Qt::SolidLine},
           {[](const ToleranceScore& score) { return score.precision; },
            ToleranceText::tr("precision"), colors.second, Qt::DashLine},
           {[](const ToleranceScore& score) { return score.recall; }, ToleranceText::tr("recall"),
            colors.third, Qt::DotLine}}};
}

void paintAxes(QPainter& painter, const Frame& frame, const QString& unit,
               const PlotColors& colors) {
  const QRectF& inner = frame.inner;
  for (const double share : {0.0, 0.5, 1.0}) {
    const double y = frame.at(frame.from, share).y();
    painter.setPen(QPen(colors.grid, 1));
    painter.drawLine(QPointF(inner.left(), y), QPointF(inner.right(), y));
    painter.setPen(colors.text);
    painter.drawText(QRectF(inner.left() - 36, y - 8, 30, 16), Qt::AlignRight | Qt::AlignVCenter,
                     QString::number(share, 'f', 1));
  }
  paintNumbersBelow(painter, inner, frame.from, frame.to, colors);
  constexpr double beside = 36; // where a narrow plot leaves no room for the name between its ends
  const QRectF below(inner.left() - beside, inner.bottom() + 19, inner.width() + 2 * beside, 16);
  painter.drawText(below, Qt::AlignCenter,
                   unit.isEmpty() ? ToleranceText::tr("tolerance")
                                  : ToleranceText::tr("tolerance [%1]").arg(unit));
}

/// Names at the right ends of the lines, moved apart where these meet.
void paintNames(QPainter& painter, const Frame& frame, const std::array<Line, 3>& lines,
                const ToleranceScore& last) {
  struct Name {
    double y;
    const Line* line;
  };
  std::vector<Name> names;
  names.reserve(lines.size());
  for (const Line& line : lines)
    names.push_back({frame.at(frame.to, line.share(last)).y(), &line});
  std::ranges::sort(names, {}, &Name::y);
  constexpr double apart = 14;
  for (std::size_t i = 1; i < names.size(); ++i)
    names[i].y = std::max(names[i].y, names[i - 1].y + apart);
  const double beyond = std::max(0.0, names.back().y - frame.inner.bottom());
  for (const Name& name : names) {
    painter.setPen(name.line->color);
    painter.drawText(QRectF(frame.inner.right() + 6, name.y - beyond - 8, 60, 16),
                     Qt::AlignLeft | Qt::AlignVCenter, name.line->name);
  }
}

void paintChosen(QPainter& painter, const Frame& frame, const std::array<Line, 3>& lines,
                 const ToleranceScore& chosen, const PlotColors& colors) {
  if (chosen.distance < frame.from || chosen.distance > frame.to) return;
  painter.setPen(QPen(colors.text, 1));
  painter.drawLine(frame.at(chosen.distance, 0), frame.at(chosen.distance, 1));
  for (const Line& line : lines) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(line.color);
    painter.drawEllipse(frame.at(chosen.distance, line.share(chosen)), 3.5, 3.5);
  }
  painter.setBrush(Qt::NoBrush);
}

} // namespace

void TolerancePlot::paint(QPainter& painter, const QRectF& box, const PlotColors& colors) const {
  if (curve.size() < 2 || curve.back().distance <= curve.front().distance) return;
  const PlotPainting painting(painter);
  const Frame frame = frameOf(*this, box);
  const std::array<Line, 3> lines = linesOf(colors);
  paintAxes(painter, frame, unit, colors);
  for (const Line& line : lines) {
    QPainterPath path(frame.at(curve.front().distance, line.share(curve.front())));
    for (const ToleranceScore& score : curve)
      path.lineTo(frame.at(score.distance, line.share(score)));
    painter.setPen(QPen(line.color, 1.75, line.style, Qt::FlatCap, Qt::RoundJoin));
    painter.drawPath(path);
  }
  paintNames(painter, frame, lines, curve.back());
  if (chosen) paintChosen(painter, frame, lines, *chosen, colors);
}

ToleranceScore TolerancePlot::scoreAt(double tolerance) const {
  const auto above = std::ranges::lower_bound(curve, tolerance, {}, &ToleranceScore::distance);
  if (above == curve.begin()) return curve.front();
  if (above == curve.end()) return curve.back();
  const ToleranceScore& from = *(above - 1);
  const double share = (tolerance - from.distance) / (above->distance - from.distance);
  return {.distance = tolerance,
          .precision = from.precision + share * (above->precision - from.precision),
          .recall = from.recall + share * (above->recall - from.recall)};
}

std::optional<double> TolerancePlot::toleranceAt(const QPointF& place, const QRectF& box) const {
  if (curve.size() < 2) return std::nullopt;
  const Frame frame = frameOf(*this, box);
  if (frame.inner.width() <= 0) return std::nullopt;
  const double share = std::clamp((place.x() - frame.inner.left()) / frame.inner.width(), 0.0, 1.0);
  return frame.from + share * (frame.to - frame.from);
}

} // namespace espalier
