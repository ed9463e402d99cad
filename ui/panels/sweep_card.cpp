#include "ui/panels/sweep_card.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include <algorithm>

namespace espalier {
namespace {

constexpr int cardMargin = 8;
constexpr int cardRowHeight = 15;
constexpr int headHeight = 20;
constexpr int leastPicture = 56; // height
constexpr int scoresWidth = 128; // beside a picture

/// For those who do not see it: the value, and what came of it.
QString spoken(const SweepItem& item) {
  QStringList parts = {item.label};
  if (item.isCurrent) parts.append(SweepCard::tr("set"));
  if (item.isPending) parts.append(SweepCard::tr("is computed"));
  if (!item.failure.isEmpty()) parts.append(item.failure);
  for (const SweepScore& score : item.scores)
    parts.append(score.isBest ? SweepCard::tr("%1 %2, best").arg(score.name, score.text)
                              : QStringLiteral("%1 %2").arg(score.name, score.text));
  return parts.join(QStringLiteral("; "));
}

} // namespace

SweepCard::SweepCard(QWidget* parent) : QAbstractButton(parent) {
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::PointingHandCursor);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  setMaximumWidth(2 * (side + cardMargin));
  setAttribute(Qt::WA_Hover); // is painted anew when the pointer comes
}

void SweepCard::setItem(const SweepItem& item) {
  item_ = item;
  setAccessibleName(spoken(item));
  setToolTip(!item.failure.isEmpty() ? item.failure
             : item.isPending        ? QString()
             : item.isCurrent        ? tr("%1 %2 is set").arg(item.of, item.label)
                                     : tr("Click to set %1 %2").arg(item.of, item.label));
  update();
}

void SweepCard::setRows(std::size_t rows) {
  rows_ = rows;
  updateGeometry();
}

QSize SweepCard::sizeHint() const {
  return sizeWith(side);
}

QSize SweepCard::minimumSizeHint() const {
  return sizeWith(leastPicture);
}

QSize SweepCard::sizeWith(int pictureHeight) const {
  const int texts = headHeight + cardRowHeight * static_cast<int>(rows_);
  return {side + 2 * cardMargin,
          2 * cardMargin + (isWide() ? std::max(texts, pictureHeight) : texts + pictureHeight)};
}

/// Are the texts beside the picture? Most plants are high.
bool SweepCard::isWide() const {
  return width() >= side + scoresWidth / 2 + 3 * cardMargin;
}

QRect SweepCard::pictureBox() const {
  const QRect inside = rect().adjusted(cardMargin, cardMargin, -cardMargin, -cardMargin);
  const int texts = headHeight + cardRowHeight * static_cast<int>(rows_);
  return isWide() ? inside.adjusted(0, 0, -scoresWidth - cardMargin, 0)
                  : inside.adjusted(0, 0, 0, -texts);
}

/// Of the value and how it stands.
QRect SweepCard::headBox() const {
  const QRect picture = pictureBox();
  if (isWide()) return {picture.right() + 1 + cardMargin, cardMargin, scoresWidth, headHeight};
  return {picture.left(), picture.bottom() + 1, picture.width(), headHeight};
}

/// Of all scores, a row each.
QRect SweepCard::scoreBox() const {
  const QRect head = headBox();
  return {head.left(), head.bottom() + 1, head.width(), cardRowHeight * static_cast<int>(rows_)};
}

void SweepCard::resizeEvent(QResizeEvent* event) {
  QAbstractButton::resizeEvent(event);
  emit resized();
}

bool SweepCard::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QAbstractButton::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  const int row = (help->pos().y() - scoreBox().top()) / cardRowHeight;
  const bool isOnScore = scoreBox().contains(help->pos()) && row < std::ssize(item_.scores);
  if (!isOnScore) return QAbstractButton::event(event);
  const QString& tip = item_.scores[static_cast<std::size_t>(row)].tip;
  QToolTip::showText(help->globalPos(), QStringLiteral("<qt>%1</qt>").arg(tip.toHtmlEscaped()),
                     this);
  return true;
}

void SweepCard::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const double line = item_.isCurrent ? 2 : 1;
  QPainterPath frame;
  frame.addRoundedRect(QRectF(rect()).adjusted(line / 2, line / 2, -line / 2, -line / 2), 4, 4);
  painter.fillPath(frame, palette().color(QPalette::Base));
  painter.setPen(QPen(
      palette().color(item_.isCurrent || underMouse() ? QPalette::Link : QPalette::Mid), line));
  painter.drawPath(frame);
  if (hasFocus()) {
    painter.setPen(QPen(palette().color(QPalette::Text), 1, Qt::DotLine));
    painter.drawRoundedRect(QRectF(rect()).adjusted(3.5, 3.5, -3.5, -3.5), 3, 3);
  }
  paintPicture(painter, pictureBox());
  const QRect head = headBox();
  QFont bold = font();
  bold.setBold(true);
  painter.setFont(bold);
  painter.setPen(palette().color(QPalette::Text));
  const QString use = item_.isCurrent ? tr("set") : QString();
  painter.drawText(head, Qt::AlignRight | Qt::AlignVCenter, use);
  const int room =
      head.width() - (use.isEmpty() ? 0 : painter.fontMetrics().horizontalAdvance(use) + 8);
  painter.drawText(head, Qt::AlignLeft | Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(item_.label, Qt::ElideRight, room));
  paintScores(painter, scoreBox());
}

/// A failure says why in place of the picture; what is to come stays quiet.
void SweepCard::paintPicture(QPainter& painter, const QRect& box) const {
  painter.fillRect(box, palette().color(QPalette::Window));
  if (item_.failure.isEmpty() && !item_.isPending && !item_.picture.isNull()) {
    QSizeF size = item_.picture.size();
    size.scale(box.size(), Qt::KeepAspectRatio);
    QRectF place(QPointF(), size);
    place.moveCenter(QRectF(box).center());
    painter.drawImage(place, item_.picture);
    return;
  }
  painter.setPen(
      palette().color(item_.failure.isEmpty() ? QPalette::PlaceholderText : QPalette::Text));
  painter.drawText(box.adjusted(cardMargin, cardMargin, -cardMargin, -cardMargin),
                   Qt::AlignCenter | Qt::TextWordWrap,
                   !item_.failure.isEmpty() ? QStringLiteral("⚠ ") + item_.failure
                   : item_.isPending        ? QStringLiteral("…")
                                            : QString());
}

/// Names on the left, numbers aligned on the right, the best of the strip bold and marked.
void SweepCard::paintScores(QPainter& painter, const QRect& box) const {
  QFont small = font();
  small.setPixelSize(11);
  QRect row(box.left(), box.top(), box.width(), cardRowHeight);
  for (const SweepScore& score : item_.scores) {
    small.setBold(score.isBest);
    painter.setFont(small);
    const QFontMetrics metrics(small);
    const int mark = metrics.horizontalAdvance(QStringLiteral("★")) + 2;
    const int number = metrics.horizontalAdvance(score.text);
    const QRect name = row.adjusted(0, 0, -number - mark - 6, 0);
    painter.setPen(palette().color(score.isBest ? QPalette::Text : QPalette::PlaceholderText));
    painter.drawText(name, Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(score.name, Qt::ElideRight, name.width()));
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(row.adjusted(0, 0, -mark, 0), Qt::AlignRight | Qt::AlignVCenter, score.text);
    if (score.isBest) {
      painter.setPen(palette().color(QPalette::Link));
      painter.drawText(row, Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("★"));
    }
    row.translate(0, cardRowHeight);
  }
}

/// Buttons are pressed with Space; here Enter chooses as well.
void SweepCard::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
    click();
  else
    QAbstractButton::keyPressEvent(event);
}

void SweepCard::enterEvent(QEnterEvent* event) {
  QAbstractButton::enterEvent(event);
  emit hovered(true);
}

void SweepCard::leaveEvent(QEvent* event) {
  QAbstractButton::leaveEvent(event);
  emit hovered(false);
}

void SweepCard::focusInEvent(QFocusEvent* event) {
  QAbstractButton::focusInEvent(event);
  if (event->reason() != Qt::MouseFocusReason) emit hovered(true);
}

void SweepCard::focusOutEvent(QFocusEvent* event) {
  QAbstractButton::focusOutEvent(event);
  if (!underMouse()) emit hovered(false);
}

} // namespace espalier
