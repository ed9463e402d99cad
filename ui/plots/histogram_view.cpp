#include "ui/plots/histogram_view.h"

#include "ui/document/length_unit.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

constexpr double grip = 5;       // how near the pointer takes an end of the brush [px]
constexpr double leastDrag = 3;  // less is a click [px]
constexpr double fineness = 0.1; // of a move of the mouse or a key, with Shift

std::size_t countBetween(const std::vector<float>& values, double from, double to) {
  std::size_t count = 0;
  for (const float value : values)
    count += static_cast<std::size_t>(value >= from && value <= to);
  return count;
}

} // namespace

HistogramView::HistogramView(QWidget* parent) : QWidget(parent) {
  setObjectName("histogram");
  setAccessibleName(tr("Histogram"));
  setMinimumSize(200, 90);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setCursor(Qt::CrossCursor);
}

void HistogramView::show(const PlottedValues& values) {
  drag_.reset();
  isKeyHeld_ = false;
  std::optional<HistogramPlot::Brush> brush;
  if (plot_.title == values.title) brush = plot_.brush;
  values_ = values.values;
  plot_.bins = binned(values_, values.range);
  plot_.title = values.title;
  plot_.unit = values.unit;
  plot_.mark = values.mark;
  plot_.areComing = values.areComing;
  plot_.brush.reset();
  addSecond(secondValues_, plot_.secondName);
  setAccessibleName(tr("Histogram: %1").arg(values.title));
  if (brush && !plot_.bins.isEmpty()) mark(brush->from, brush->to);
  describe();
  update();
}

void HistogramView::addSecond(const std::vector<float>& values, const QString& name) {
  if (&values != &secondValues_) secondValues_ = values;
  plot_.secondName = name;
  plot_.second.reset();
  if (!values.empty() && !plot_.bins.isEmpty()) plot_.second = binnedAs(plot_.bins, values);
  update();
}

void HistogramView::setDark(bool isDark) {
  isDark_ = isDark;
  update();
}

bool HistogramView::isMeant(const QKeyEvent& event) const {
  if (event.key() == Qt::Key_Escape) return plot_.brush.has_value() || drag_.has_value();
  return event.key() >= Qt::Key_Left && event.key() <= Qt::Key_Down && !plot_.bins.isEmpty();
}

bool HistogramView::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && isMeant(*static_cast<QKeyEvent*>(event))) {
    event->accept();
    return true;
  }
  if (event->type() == QEvent::ToolTip) {
    const auto* help = static_cast<QHelpEvent*>(event);
    QString tip = plot_.tipAt(help->pos(), rect());
    if (tip.isEmpty()) tip = plot_.title;
    if (plot_.mark) tip += '\n' + tr("Dashed line: %1").arg(plot_.mark->text);
    if (plot_.bins.missing > 0)
      tip += '\n' + tr("%1 have no value").arg(formatCount(plot_.bins.missing));
    tip += '\n' + tr("Drag to mark a range, click to clear it");
    QToolTip::showText(help->globalPos(), tip, this);
    return true;
  }
  return QWidget::event(event);
}

void HistogramView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  plot_.paint(painter, rect(), plotColors(isDark_));
  if (!hasFocus()) return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1));
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

std::optional<double> HistogramView::farEnd(double x) const {
  if (!plot_.brush) return std::nullopt;
  const double fromLeft = std::abs(x - plot_.placeOf(plot_.brush->from, rect()));
  const double fromRight = std::abs(x - plot_.placeOf(plot_.brush->to, rect()));
  if (std::min(fromLeft, fromRight) > grip) return std::nullopt;
  return fromLeft < fromRight ? plot_.brush->to : plot_.brush->from;
}

void HistogramView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || plot_.bins.isEmpty()) return;
  const double x = event->position().x();
  const double anchor = farEnd(x).value_or(plot_.valueAt(x, rect()));
  drag_ = Drag{.start = x, .at = x, .mouse = x, .anchor = anchor, .before = plot_.brush};
}

void HistogramView::mouseMoveEvent(QMouseEvent* event) {
  const double x = event->position().x();
  if (!drag_) {
    setCursor(farEnd(x) ? Qt::SplitHCursor : Qt::CrossCursor);
    return;
  }
  const bool isFine = event->modifiers().testFlag(Qt::ShiftModifier);
  drag_->at += (isFine ? fineness : 1) * (x - drag_->mouse);
  drag_->mouse = x;
  if (!drag_->hasMoved && std::abs(x - drag_->start) < leastDrag) return;
  drag_->hasMoved = true;
  const double value = plot_.valueAt(drag_->at, rect());
  mark(std::min(value, drag_->anchor), std::max(value, drag_->anchor));
  reportMarked(false);
}

void HistogramView::mouseReleaseEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton || !drag_) return;
  const bool hasMoved = drag_->hasMoved;
  drag_.reset();
  if (hasMoved)
    reportMarked(true);
  else
    clear();
}

void HistogramView::keyPressEvent(QKeyEvent* event) {
  if (!isMeant(*event)) return QWidget::keyPressEvent(event);
  if (event->key() == Qt::Key_Escape) {
    if (drag_)
      cancelDrag();
    else
      clear();
    return;
  }
  if (drag_) return;
  const double binsPerKey = event->modifiers().testFlag(Qt::ShiftModifier) ? fineness : 1;
  const bool isMove = event->key() == Qt::Key_Left || event->key() == Qt::Key_Right;
  const bool isMore = event->key() == Qt::Key_Right || event->key() == Qt::Key_Up;
  const double amount = (isMore ? binsPerKey : -binsPerKey) * plot_.bins.width();
  isKeyHeld_ = event->isAutoRepeat();
  step(isMove ? amount : 0, isMove ? 0 : amount);
}

void HistogramView::keyReleaseEvent(QKeyEvent* event) {
  if (isKeyHeld_ && !event->isAutoRepeat() && plot_.brush) {
    isKeyHeld_ = false;
    reportMarked(true);
    return;
  }
  QWidget::keyReleaseEvent(event);
}

/// The first key marks the middle third, which the next ones change.
void HistogramView::step(double move, double widen) {
  const BinnedValues& bins = plot_.bins;
  const double least = plot_.least();
  const double greatest = plot_.greatest();
  if (!plot_.brush) {
    const double third = (bins.to - bins.from) / 3;
    mark(bins.from + third, bins.to - third);
  } else {
    const auto [from, to, count] = *plot_.brush;
    const double shift = std::clamp(move, least - from, std::max(greatest - to, least - from));
    const double half = std::max(widen, (from - to) / 2 + fineness * bins.width() / 2);
    mark(std::max(from + shift - half, least), std::min(to + shift + half, greatest));
  }
  reportMarked(!isKeyHeld_);
}

void HistogramView::mark(double from, double to) {
  plot_.brush = HistogramPlot::Brush{from, to, countBetween(values_, from, to)};
  describe();
  update();
}

void HistogramView::clear() {
  if (!plot_.brush) return;
  plot_.brush.reset();
  isKeyHeld_ = false;
  describe();
  update();
  emit brushCleared();
}

/// Leaves what was marked before the drag.
void HistogramView::cancelDrag() {
  const Drag drag = *drag_;
  drag_.reset();
  if (!drag.hasMoved) return;
  if (!drag.before) return clear();
  mark(drag.before->from, drag.before->to);
  reportMarked(true);
}

void HistogramView::reportMarked(bool isFinal) {
  emit brushed(plot_.brush->from, plot_.brush->to, isFinal);
}

/// For those who do not see it.
void HistogramView::describe() {
  if (plot_.bins.isEmpty())
    setAccessibleDescription(plot_.emptyText());
  else if (plot_.brush)
    setAccessibleDescription(plot_.brushText());
  else
    setAccessibleDescription(tr("%1 values from %2 to %3 %4")
                                 .arg(formatCount(plot_.bins.total),
                                      plot_.numberOf(plot_.bins.least),
                                      plot_.numberOf(plot_.bins.greatest), plot_.unit)
                                 .trimmed());
}

} // namespace espalier
