#pragma once

#include "ui/panels/sweep_card.h"

#include <QWidget>

#include <cstddef>
#include <optional>
#include <vector>

class QHBoxLayout;
class QScrollArea;

namespace espalier {

/// A strip of small pictures, one per value of a parameter, which scrolls sideways.
///
/// A click or Enter chooses a card, the arrow keys, Home and End go from card to card. What is
/// still computed or has failed cannot be chosen.
class SweepStrip : public QWidget {
  Q_OBJECT

public:
  explicit SweepStrip(QWidget* parent = nullptr);

  void setItems(const std::vector<SweepItem>& items);
  void setItem(std::size_t index, const SweepItem& item); // pre: index < count of the items
  void setLeastRows(std::size_t rows); // that there is room for before there are scores
  /// What it takes to see all scores [px]; lower strips scroll.
  [[nodiscard]] int heightForScores() const;
  /// Of each card [px]; pre: there are cards
  [[nodiscard]] QSize pictureSize() const { return cards_.front()->pictureSize(); }
  [[nodiscard]] const std::vector<SweepCard*>& cards() const { return cards_; }

signals:
  void chosen(std::size_t index);
  void hovered(std::optional<std::size_t> index); // by the pointer or the focus; none: no card
  void resized();                                 // pictures have other room

protected:
  bool eventFilter(QObject* watched, QEvent* event) override; // of the cards

private:
  void addCard(std::size_t index);
  void resizeCards();
  [[nodiscard]] std::optional<std::size_t> reached(const QObject* card, int key) const;

  QScrollArea* scroll_;
  QWidget* page_;
  QHBoxLayout* row_;
  std::vector<SweepCard*> cards_;
  std::size_t leastRows_ = 0;
};

} // namespace espalier
