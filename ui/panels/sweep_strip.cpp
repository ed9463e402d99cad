#include "ui/panels/sweep_strip.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <algorithm>

namespace espalier {

SweepStrip::SweepStrip(QWidget* parent)
    : QWidget(parent), scroll_(new QScrollArea(this)), page_(new QWidget),
      row_(new QHBoxLayout(page_)) {
  setObjectName("sweep_strip");
  setAccessibleName(tr("Sweep"));
  row_->setContentsMargins(8, 8, 8, 8);
  row_->setSpacing(8);
  row_->addStretch();
  scroll_->setWidget(page_);
  scroll_->setWidgetResizable(true);
  scroll_->setFrameShape(QFrame::NoFrame);
  scroll_->setFocusPolicy(Qt::NoFocus); // the cards have it
  scroll_->setMinimumHeight(96);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(scroll_);
  resizeCards();
}

void SweepStrip::setItems(const std::vector<SweepItem>& items) {
  while (cards_.size() > items.size()) {
    delete cards_.back();
    cards_.pop_back();
  }
  while (cards_.size() < items.size())
    addCard(cards_.size());
  for (std::size_t i = 0; i < items.size(); ++i)
    cards_[i]->setItem(items[i]);
  resizeCards();
}

void SweepStrip::setItem(std::size_t index, const SweepItem& item) {
  cards_[index]->setItem(item);
  resizeCards();
}

void SweepStrip::addCard(std::size_t index) {
  auto* card = new SweepCard(page_);
  card->installEventFilter(this);
  row_->insertWidget(row_->count() - 1, card, 1);
  cards_.push_back(card);
  connect(card, &SweepCard::clicked, this, [this, card, index] {
    const SweepItem& item = card->item();
    if (!item.isPending && item.failure.isEmpty()) emit chosen(index);
  });
  connect(card, &SweepCard::resized, this, &SweepStrip::resized);
  connect(card, &SweepCard::hovered, this, [this, index](bool isInside) {
    emit hovered(isInside ? std::optional(index) : std::nullopt);
  });
}

void SweepStrip::setLeastRows(std::size_t rows) {
  leastRows_ = rows;
  resizeCards();
}

/// All cards have room for the most scores.
void SweepStrip::resizeCards() {
  std::size_t rows = leastRows_;
  for (const SweepCard* card : cards_)
    rows = std::max(rows, card->item().scores.size());
  for (SweepCard* card : cards_)
    card->setRows(rows);
}

int SweepStrip::heightForScores() const {
  const int height = cards_.empty() ? 0 : cards_.front()->minimumSizeHint().height() + 16;
  return height + scroll_->horizontalScrollBar()->sizeHint().height();
}

/// The card that a key leads to from this one; none: it is another key.
std::optional<std::size_t> SweepStrip::reached(const QObject* card, int key) const {
  const auto here = static_cast<std::size_t>(std::ranges::find(cards_, card) - cards_.begin());
  if (key == Qt::Key_Right || key == Qt::Key_Down) return std::min(here + 1, cards_.size() - 1);
  if (key == Qt::Key_Left || key == Qt::Key_Up) return here == 0 ? here : here - 1;
  if (key == Qt::Key_Home) return 0;
  if (key == Qt::Key_End) return cards_.size() - 1;
  return std::nullopt;
}

/// The keys of the strip are no shortcuts while a card has the focus; the wheel scrolls sideways.
bool SweepStrip::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Wheel) {
    const QPoint angle = static_cast<QWheelEvent*>(event)->angleDelta();
    QScrollBar* sideways = scroll_->horizontalScrollBar();
    QScrollBar* bar = sideways->maximum() > 0 ? sideways : scroll_->verticalScrollBar();
    bar->setValue(bar->value() - (angle.x() != 0 ? angle.x() : angle.y()));
    return true;
  }
  const bool isOverride = event->type() == QEvent::ShortcutOverride;
  if (!isOverride && event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  const std::optional<std::size_t> card = reached(watched, key);
  if (isOverride && (card || key == Qt::Key_Return || key == Qt::Key_Enter)) {
    event->accept();
    return true;
  }
  if (isOverride || !card) return QWidget::eventFilter(watched, event);
  cards_[*card]->setFocus(Qt::OtherFocusReason);
  scroll_->ensureWidgetVisible(cards_[*card], 8, 0);
  return true;
}

} // namespace espalier
