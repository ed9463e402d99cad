#include "ui/panels/coverage_bar.h"

#include "ui/document/review_look.h"
#include "ui/panels/coverage_text.h"

#include <QEvent>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>

namespace espalier {

CoverageBar::CoverageBar(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setAccessibleName(tr("Review coverage"));
}

void CoverageBar::setCoverage(const ReviewCoverage& coverage) {
  coverage_ = coverage;
  const auto percent = [&](ReviewState state) { return percentText(coverage, state, 0); };
  setAccessibleDescription(
      tr("%1 % reviewed, %2 % doubtful")
          .arg(percent(ReviewState::reviewed), percent(ReviewState::doubtful)));
  update();
}

QPixmap CoverageBar::sample(ReviewState state) const {
  constexpr int side = 10;
  QPixmap pixmap(QSize(side, side) * devicePixelRatioF());
  pixmap.setDevicePixelRatio(devicePixelRatioF());
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  fill(painter, QRectF(0, 0, side, side), state);
  return pixmap;
}

void CoverageBar::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) emit colorsChanged();
}

void CoverageBar::paintEvent(QPaintEvent* event) {
  Q_UNUSED(event)
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath outline;
  outline.addRoundedRect(rect(), 3, 3);
  painter.setClipPath(outline);
  fill(painter, rect(), ReviewState::toDo);
  double from = 0;
  for (const ReviewState state : {ReviewState::reviewed, ReviewState::doubtful}) {
    const double width = coverage_.share(state) * this->width();
    fill(painter, QRectF(from, 0, width, height()), state);
    from += width;
  }
}

void CoverageBar::fill(QPainter& painter, const QRectF& part, ReviewState state) const {
  if (state == ReviewState::toDo) // what is missing is empty
    return painter.fillRect(part, palette().color(QPalette::Mid));
  const bool isDark = palette().color(QPalette::Window).lightness() < 128;
  const Color color = colorOf(state, isDark);
  painter.fillRect(part, QColor(color[0], color[1], color[2]));
  if (state == ReviewState::doubtful)
    painter.fillRect(part, QBrush(palette().color(QPalette::Window), Qt::BDiagPattern));
}

} // namespace espalier
