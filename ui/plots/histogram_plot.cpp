#include "ui/plots/histogram_plot.h"

#include "ui/document/length_unit.h"
#include "ui/document/number_scale.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr double besideWidth = 8; // of a bar for all beyond [px]
constexpr double besideGap = 3;

struct HistogramText {
  Q_DECLARE_TR_FUNCTIONS(HistogramPlot)
};

QString percent(std::size_t count, std::size_t total) {
  const double share = 100 * static_cast<double>(count) / static_cast<double>(total);
  const bool isSmall = share < 9.95 && count > 0;
  return QStringLiteral("%1 %").arg(share, 0, 'f', isSmall ? 1 : 0).replace(' ', QChar(0x202f));
}

/// A bar: what it stands for, and where it is painted.
struct Bar {
  double from;
  double to;
  double left;
  double right;
  std::size_t count;
  std::size_t secondCount;
};

/// Where the bins are painted; to their sides are the bars for what lies beyond.
QRectF innerOf(const HistogramPlot& plot, const QRectF& box) {
  const double room = besideWidth + besideGap;
  return box.adjusted(10 + (plot.least() < plot.bins.from ? room : 0), 22,
                      -10 - (plot.greatest() > plot.bins.to ? room : 0), -22);
}

std::vector<Bar> barsOf(const HistogramPlot& plot, const QRectF& box) {
  const BinnedValues& bins = plot.bins;
  const QRectF inner = innerOf(plot, box);
  const auto secondCount = [&](std::size_t i) { return plot.second ? plot.second->counts[i] : 0; };
  const std::size_t below = plot.second ? plot.second->below : 0;
  const std::size_t above = plot.second ? plot.second->above : 0;
  const double width = inner.width() / static_cast<double>(bins.counts.size());
  std::vector<Bar> bars;
  if (plot.least() < bins.from) {
    const double right = inner.left() - besideGap;
    bars.push_back({plot.least(), bins.from, right - besideWidth, right, bins.below, below});
  }
  for (std::size_t i = 0; i < bins.counts.size(); ++i) {
    const auto place = static_cast<double>(i);
    const double from = bins.from + place * bins.width();
    const double left = inner.left() + place * width;
    bars.push_back({from, from + bins.width(), left, left + width, bins.counts[i], secondCount(i)});
  }
  if (plot.greatest() > bins.to) {
    const double left = inner.right() + besideGap;
    bars.push_back({bins.to, plot.greatest(), left, left + besideWidth, bins.above, above});
  }
  return bars;
}

/// Heights of both sets are shares of each: sets of any size can be compared.
class Heights {
public:
  Heights(const HistogramPlot& plot, const std::vector<Bar>& bars, double height)
      : total_(static_cast<double>(plot.bins.total)),
        secondTotal_(plot.second ? static_cast<double>(plot.second->total) : 0) {
    double most = 0;
    for (const Bar& bar : bars)
      most = std::max({most, share(bar.count, total_), share(bar.secondCount, secondTotal_)});
    scale_ = most > 0 ? height / most : 0;
  }

  [[nodiscard]] double of(const Bar& bar) const { return seen(bar.count, total_); }
  [[nodiscard]] double ofSecond(const Bar& bar) const {
    return seen(bar.secondCount, secondTotal_);
  }

private:
  static double share(std::size_t count, double total) {
    return total > 0 ? static_cast<double>(count) / total : 0;
  }
  /// What is there at all is seen.
  [[nodiscard]] double seen(std::size_t count, double total) const {
    return count == 0 ? 0 : std::max(1.0, scale_ * share(count, total));
  }

  double total_;
  double secondTotal_;
  double scale_;
};

void paintBars(QPainter& painter, const HistogramPlot& plot, const std::vector<Bar>& bars,
               const Heights& heights, double bottom, const QRectF& box, const PlotColors& colors) {
  QColor plain = colors.text;
  plain.setAlphaF(0.55F);
  QColor outside = colors.text;
  outside.setAlphaF(0.22F);
  const QRectF marked = plot.brush ? QRectF(QPointF(plot.placeOf(plot.brush->from, box), 0),
                                            QPointF(plot.placeOf(plot.brush->to, box), bottom))
                                   : QRectF();
  painter.setRenderHint(QPainter::Antialiasing, false); // bars join without seams
  for (const Bar& bar : bars) {
    const QRectF filled(bar.left, bottom - heights.of(bar), bar.right - bar.left, heights.of(bar));
    painter.fillRect(filled, plot.brush ? outside : plain);
    if (!plot.brush) continue;
    const double left = std::max(bar.left, marked.left());
    const double right = std::min(bar.right, marked.right());
    if (right > left)
      painter.fillRect(QRectF(left, filled.top(), right - left, filled.height()), colors.chosen);
  }
  painter.setRenderHint(QPainter::Antialiasing);
}

void paintOutline(QPainter& painter, const std::vector<Bar>& bars, const Heights& heights,
                  double bottom, const PlotColors& colors) {
  QPainterPath path(QPointF(bars.front().left, bottom));
  for (const Bar& bar : bars) {
    path.lineTo(bar.left, bottom - heights.ofSecond(bar));
    path.lineTo(bar.right, bottom - heights.ofSecond(bar));
  }
  path.lineTo(bars.back().right, bottom);
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(colors.second, 1.5));
  painter.drawPath(path);
}

/// The ends of the marked range, seen without colors, too.
void paintEnds(QPainter& painter, const HistogramPlot& plot, const QRectF& inner, const QRectF& box,
               const PlotColors& colors) {
  painter.setPen(QPen(colors.text, 1));
  painter.setBrush(colors.chosen);
  for (const double value : {plot.brush->from, plot.brush->to}) {
    const double x = plot.placeOf(value, box);
    painter.drawLine(QPointF(x, inner.top()), QPointF(x, inner.bottom()));
    painter.drawRoundedRect(QRectF(x - 2.5, inner.center().y() - 7, 5, 14), 2, 2);
  }
  painter.setBrush(Qt::NoBrush);
}

/// Its line is dashed, and its text stands on the side that has more room.
void paintMark(QPainter& painter, const HistogramPlot& plot, const QRectF& inner, const QRectF& box,
               const PlotColors& colors) {
  const double x = plot.placeOf(plot.mark->value, box);
  painter.setPen(QPen(colors.text, 1.5, Qt::DashLine));
  painter.drawLine(QPointF(x, inner.top()), QPointF(x, inner.bottom()));
  const QString& text = plot.mark->text;
  const double width = QFontMetricsF(painter.font(), painter.device()).horizontalAdvance(text) + 4;
  const bool isRight = inner.right() - x > x - inner.left();
  const QRectF place(isRight ? x + 4 : x - 4 - width, inner.top(), width, 16);
  QColor ground = colors.ground;
  ground.setAlphaF(0.8F);
  painter.fillRect(place, ground);
  painter.setPen(colors.text);
  painter.drawText(place, Qt::AlignCenter, text);
}

/// Title and unit on the left; on the right what is marked, else the name of the outline.
void paintHead(QPainter& painter, const HistogramPlot& plot, const QRectF& box,
               const PlotColors& colors) {
  const QRectF line(box.left() + 10, box.top() + 3, box.width() - 20, 16);
  const QString side = plot.brush ? plot.brushText() : plot.second ? plot.secondName : QString();
  const QFontMetricsF font(painter.font(), painter.device());
  const double sideWidth = side.isEmpty() ? 0 : font.horizontalAdvance(side) + 8;
  painter.setPen(plot.brush || !plot.second ? colors.text : colors.second);
  painter.drawText(line, Qt::AlignRight | Qt::AlignVCenter, side);
  if (!side.isEmpty() && !plot.brush) {
    const double right = line.right() - sideWidth;
    painter.setPen(QPen(colors.second, 1.5));
    painter.drawLine(QPointF(right - 12, line.center().y()), QPointF(right, line.center().y()));
  }
  const QString title =
      plot.unit.isEmpty() ? plot.title : QStringLiteral("%1 [%2]").arg(plot.title, plot.unit);
  painter.setPen(colors.text);
  painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter,
                   font.elidedText(title, Qt::ElideRight, line.width() - sideWidth - 4));
}

} // namespace

void HistogramPlot::paint(QPainter& painter, const QRectF& box, const PlotColors& colors) const {
  const PlotPainting painting(painter);
  paintHead(painter, *this, box, colors);
  if (bins.isEmpty()) {
    painter.drawText(box, Qt::AlignCenter, emptyText());
    return;
  }
  const QRectF inner = innerOf(*this, box);
  if (inner.width() <= 0 || inner.height() <= 0) return;
  const std::vector<Bar> bars = barsOf(*this, box);
  const Heights heights(*this, bars, inner.height());
  paintBars(painter, *this, bars, heights, inner.bottom(), box, colors);
  painter.setPen(QPen(colors.grid, 1));
  painter.drawLine(inner.bottomLeft(), inner.bottomRight());
  if (second) paintOutline(painter, bars, heights, inner.bottom(), colors);
  if (mark) paintMark(painter, *this, inner, box, colors);
  if (brush) paintEnds(painter, *this, inner, box, colors);
  paintNumbersBelow(painter, inner, bins.from, bins.to, colors);
}

double HistogramPlot::least() const {
  const bool hasSecond = second && second->total > 0;
  return std::min({bins.from, bins.least, hasSecond ? second->least : bins.least});
}

double HistogramPlot::greatest() const {
  const bool hasSecond = second && second->total > 0;
  return std::max({bins.to, bins.greatest, hasSecond ? second->greatest : bins.greatest});
}

double HistogramPlot::placeOf(double value, const QRectF& box) const {
  const QRectF inner = innerOf(*this, box);
  if (value < bins.from && least() < bins.from) return inner.left() - besideGap - besideWidth;
  if (value > bins.to && greatest() > bins.to) return inner.right() + besideGap + besideWidth;
  const double share = std::clamp((value - bins.from) / (bins.to - bins.from), 0.0, 1.0);
  return inner.left() + share * inner.width();
}

double HistogramPlot::valueAt(double x, const QRectF& box) const {
  const QRectF inner = innerOf(*this, box);
  if (x < inner.left() - besideGap / 2 && least() < bins.from) return least();
  if (x > inner.right() + besideGap / 2 && greatest() > bins.to) return greatest();
  const double share = std::clamp((x - inner.left()) / inner.width(), 0.0, 1.0);
  return bins.from + share * (bins.to - bins.from);
}

QString HistogramPlot::tipAt(const QPointF& place, const QRectF& box) const {
  if (bins.isEmpty() || !box.contains(place)) return {};
  for (const Bar& bar : barsOf(*this, box)) {
    if (place.x() < bar.left || place.x() >= bar.right) continue;
    const QString range = HistogramText::tr("%1 to %2").arg(numberOf(bar.from), numberOf(bar.to)) +
                          (unit.isEmpty() ? QString() : QChar(0x202f) + unit);
    QString tip = HistogramText::tr("%1: %2 of %3 (%4)")
                      .arg(range, formatCount(bar.count), formatCount(bins.total),
                           percent(bar.count, bins.total));
    if (second && second->total > 0)
      tip += '\n' + HistogramText::tr("%1: %2 of %3 (%4)")
                        .arg(secondName.isEmpty() ? HistogramText::tr("Outline") : secondName,
                             formatCount(bar.secondCount), formatCount(second->total),
                             percent(bar.secondCount, second->total));
    return tip;
  }
  return {};
}

QString HistogramPlot::brushText() const {
  return HistogramText::tr("%1 – %2 · %3 (%4)")
      .arg(numberOf(brush->from),
           numberOf(brush->to) + (unit.isEmpty() ? QString() : QChar(0x202f) + unit),
           formatCount(brush->count), percent(brush->count, bins.total));
}

QString HistogramPlot::emptyText() const {
  return areComing ? HistogramText::tr("Computing…") : HistogramText::tr("No values");
}

QString HistogramPlot::numberOf(double value) const {
  return numberAtStep(value, roundStep(bins.width()));
}

} // namespace espalier
