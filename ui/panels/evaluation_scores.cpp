#include "ui/panels/evaluation_scores.h"

#include "ui/document/hand_work_text.h"
#include "ui/document/plant_document.h"
#include "ui/document/shown_text.h"
#include "ui/panels/label_role.h"
#include "ui/panels/score_text.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>
#include <map>

namespace espalier {

namespace {

constexpr int firstRow = 1; // of the groups, below the leading scores

} // namespace

struct EvaluationScores::Place {
  int row = firstRow;
  int column = 0;
};

EvaluationScores::EvaluationScores(const PlantDocument& document) : document_(document) {
  scores_ = new QWidget;
  auto* grid = new QGridLayout(scores_);
  grid->setContentsMargins(0, 0, 8, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(2);
  addLeading(*grid);
  addScores(*grid);
  for (const int values : {1, 3}) // other numbers must not move what lies beside
    grid->setColumnMinimumWidth(values, fontMetrics().horizontalAdvance("0.000000 m"));
  grid->setRowStretch(grid->rowCount(), 1);
  setObjectName("evaluation_scores");
  setAccessibleName(tr("Scores"));
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setWidget(scores_);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  forget();
}

/// In the row above both columns: what is looked for first is seen without scrolling.
void EvaluationScores::addLeading(QGridLayout& grid) {
  auto* row = new QHBoxLayout;
  row->setSpacing(6);
  for (const Score* score : leadingFirst(scoresIn(inBrief))) {
    auto* name = makeLabel("", "quiet");
    name->setText(symbolOf(*score));
    auto* value = makeLabel(("leading_" + score->key).c_str(), "title");
    value->setAccessibleName(labelOf(*score));
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    // Other numbers must not move what lies beside.
    value->setMinimumWidth(value->fontMetrics().horizontalAdvance("0.0000"));
    for (QLabel* label : {name, value}) {
      label->setToolTip(tipOf(*score));
      row->addWidget(label);
    }
    row->addSpacing(12);
    leading_[score->key] = value;
  }
  row->addStretch(1);
  grid.addLayout(row, 0, 0, 1, 4);
}

/// The groups one below the other, in two columns of about the same height.
void EvaluationScores::addScores(QGridLayout& grid) {
  const ScoreList shown = leadingFirst(scoresIn(inPanel));
  std::map<QString, int> rowsOf; // of each group, with its title
  for (const Score* score : shown) {
    const QString title = titleOf(score->group);
    rowsOf[title] += rowsOf.contains(title) ? 1 : 2;
  }
  int rows = 0;
  for (const auto& [title, count] : rowsOf)
    rows += count;
  Place place;
  QString group;
  for (const Score* score : shown) {
    if (const QString title = titleOf(score->group); title != group) {
      const int above = place.row - firstRow;
      const bool isHalf = 2 * above + rowsOf[title] >= rows; // with half of this group
      if (place.column == 0 && isHalf) place = {.row = firstRow, .column = 1};
      addGroup(grid, place, group = title);
    }
    values_[score->key] = addValue(grid, place, titled(symbolOf(*score)), tipOf(*score),
                                   ("score_" + score->key).c_str());
  }
  stems_ = makeLabel("score_stems", "quiet");
  stems_->setWordWrap(true);
  grid.addWidget(stems_, place.row++, 2 * place.column, 1, 2);
  addGroup(grid, place, tr("Work by hand"));
  work_ = makeLabel("score_work", "value"); // in both columns: it must not widen that of numbers
  work_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  work_->setAccessibleName(tr("Work by hand"));
  grid.addWidget(work_, place.row++, 2 * place.column, 1, 2);
}

void EvaluationScores::addGroup(QGridLayout& grid, Place& place, const QString& name) {
  auto* label = makeLabel("", "quiet");
  label->setText(name);
  if (place.row > firstRow) label->setContentsMargins(0, 8, 0, 0);
  grid.addWidget(label, place.row++, 2 * place.column, 1, 2);
}

QLabel* EvaluationScores::addValue(QGridLayout& grid, Place& place, const QString& text,
                                   const QString& help, const char* name) {
  auto* label = new QLabel(text);
  label->setToolTip(help);
  grid.addWidget(label, place.row, 2 * place.column);
  auto* value = makeLabel(name, "value");
  value->setToolTip(help);
  value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  value->setTextInteractionFlags(Qt::TextSelectableByMouse);
  value->setAccessibleName(text);
  grid.addWidget(value, place.row++, 2 * place.column + 1);
  return value;
}

void EvaluationScores::show(const Evaluation& evaluation) {
  const ScoreValues& scores = evaluation.comparison.scores;
  for (const auto* labels : {&leading_, &values_})
    for (const auto& [key, value] : *labels)
      value->setText(textOf(scores.at(key), scoreOf(key).unit, document_.unit()));
  const std::string& missing = evaluation.comparison.stems.missing;
  stems_->setText(missing.empty() ? QString()
                                  : tr("No diameters at 1.3 m: %1").arg(shownText(missing)));
  stems_->setVisible(!missing.empty());
  fit();
}

void EvaluationScores::showIntervals(const std::map<std::string, ScoreInterval>& intervals) {
  for (const auto* labels : {&leading_, &values_})
    for (const auto& [key, value] : *labels) {
      QString tip = tipOf(scoreOf(key));
      if (const auto found = intervals.find(key); found != intervals.end())
        tip += '\n' + intervalText(found->second);
      value->setToolTip(tip);
    }
}

void EvaluationScores::fit() {
  constexpr int scrollBar = 14;
  scores_->layout()->activate();
  setFixedWidth(std::max(396, scores_->minimumSizeHint().width() + scrollBar));
  endBetweenRows();
}

void EvaluationScores::resizeEvent(QResizeEvent* event) {
  QScrollArea::resizeEvent(event);
  endBetweenRows();
}

/// The last row that is seen is not sliced.
void EvaluationScores::endBetweenRows() {
  const auto* grid = static_cast<QGridLayout*>(scores_->layout());
  int end = 0;
  for (int row = 0; row < grid->rowCount() - 1; ++row) // without what stretches
    if (const int bottom = grid->cellRect(row, 0).bottom() + 1; bottom <= height()) end = bottom;
  const bool isAllSeen = scores_->minimumSizeHint().height() <= height();
  setViewportMargins(0, 0, 0, isAllSeen || end == 0 ? 0 : height() - end);
}

void EvaluationScores::forget() {
  for (const auto* labels : {&leading_, &values_})
    for (const auto& [key, value] : *labels)
      value->setText(QStringLiteral("–"));
  showIntervals({});
  stems_->hide();
  fit();
}

void EvaluationScores::setStale(bool isStale) {
  for (const auto& [key, value] : values_)
    setRole(*value, isStale ? "quiet" : "value");
  for (const auto& [key, value] : leading_)
    value->setEnabled(!isStale);
}

void EvaluationScores::showHandWork(const HandWork& work) {
  const std::size_t edits = work.corrections.edits;
  work_->setText(edits == 0 ? tr("none")
                            : tr("%1, %2").arg(edits == 1 ? tr("1 edit")
                                                          : tr("%1 edits").arg(formatCount(edits)),
                                               formatWorkTime(work.time)));
  work_->setToolTip(
      tr("Since the plant was reconstructed or opened: %1").arg(describe(work.corrections)));
  fit();
}

} // namespace espalier
