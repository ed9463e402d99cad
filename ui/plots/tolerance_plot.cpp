#include "ui/plots/tolerance_plot.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainterPath>

#include <algorithm>
#include <array>
#include <cmath>

namespace espalier {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("TolerancePlot", text);
}

/// The largest of 1, 2 or 5 times a power of ten that is at most `length`.
double roundStep(double length) {
  const double power = std::pow(10, std::floor(std::log10(length) + 1e-9));
  const double rest = length / power * (1 + 1e-9);
  return (rest >= 5 ? 5 : rest >= 2 ? 2 : 1) * power;
}

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
  return {{{[](const ToleranceScore& score) { return score.f(); }, tr("F"), colors.first,
            Qt::SolidLine},
           {[](const ToleranceScore& score) { return score.precision; }, tr("precision"),
            colors.second, Qt::DashLine},
           {[](const ToleranceScore& score) { return score.recall; }, tr("recall"), colors.third,
            Qt::DotLine}}};
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
  const double step = roundStep((frame.to - frame.from) / 3);
  const int decimals = std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 9);
  for (double tolerance = std::ceil(frame.from / step) * step; tolerance <= frame.to * (1 + 1e-9);
       tolerance += step) {
    const double x = frame.at(tolerance, 0).x();
    painter.setPen(QPen(colors.grid, 1));
    painter.drawLine(QPointF(x, inner.bottom()), QPointF(x, inner.bottom() + 4));
    painter.setPen(colors.text);
    painter.drawText(QRectF(x - 40, inner.bottom() + 4, 80, 16), Qt::AlignCenter,
                     QString::number(tolerance, 'f', decimals));
  }
  painter.drawText(QRectF(inner.left(), inner.bottom() + 19, inner.width(), 16), Qt::AlignCenter,
                   unit.isEmpty() ? tr("tolerance") : tr("tolerance [%1]").arg(unit));
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

PlotColors plotColors(bool isDark) {
  if (isDark)
    return {.text = {0xc8, 0xce, 0xcb},
            .grid = {0x4a, 0x50, 0x55},
            .first = {0xf4, 0xf4, 0xf0},
            .second = {0xe6, 0x9f, 0x00},
            .third = {0x56, 0xb4, 0xe9}};
  return {.text = {0x3a, 0x40, 0x3d},
          .grid = {0xc8, 0xce, 0xcb},
          .first = {0x16, 0x18, 0x1a},
          .second = {0xd5, 0x5e, 0x00},
          .third = {0x00, 0x72, 0xb2}};
}

void TolerancePlot::paint(QPainter& painter, const QRectF& box, const PlotColors& colors) const {
  if (curve.size() < 2 || curve.back().distance <= curve.front().distance) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  QFont font = painter.font();
  font.setPixelSize(11);
  painter.setFont(font);
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
  painter.restore();
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
