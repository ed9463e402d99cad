#include "ui/panels/evaluation_scores.h"

#include "ui/document/hand_work_text.h"
#include "ui/document/plant_document.h"
#include "ui/panels/label_role.h"

#include <QGridLayout>
#include <QLabel>

#include <algorithm>

namespace espalier {
namespace {

QString shareText(double share) {
  return QString::number(share, 'f', 3);
}

} // namespace

EvaluationScores::EvaluationScores(const PlantDocument& document) : document_(document) {
  scores_ = new QWidget;
  auto* grid = new QGridLayout(scores_);
  grid->setContentsMargins(0, 0, 8, 0);
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(2);
  const auto add = [&](int row, int column, const QString& text, const QString& help,
                       const char* name) { return addScore(*grid, row, column, text, help, name); };
  f_ = add(0, 0, tr("F"), tr("Harmonic mean of precision and recall"), "score_f");
  precision_ = add(1, 0, tr("Precision"), tr("Share of the plant's length near the reference"),
                   "score_precision");
  recall_ =
      add(2, 0, tr("Recall"), tr("Share of the reference's length near the plant"), "score_recall");
  tips_ = add(3, 0, tr("Tips, F"), tr("Ends that lie within a median edge of each other"),
              "score_tips");
  branchings_ =
      add(4, 0, tr("Branchings, F"), tr("Branchings that lie within a median edge of each other"),
          "score_branchings");
  distances_ = add(5, 0, tr("Mean distance"),
                   tr("From the plant to the reference, and from the reference to the plant"),
                   "score_distance");
  edits_ = add(6, 0, tr("Edit distance"),
               tr("Segments to remove or insert to make one of the other"), "score_edits");
  mapping_ = add(0, 1, tr("Mapping"),
                 tr("Share of the segments of both that are matched (authors)"), "score_mapping");
  geometric_ = add(1, 1, tr("Geometric G"),
                   tr("Share of the length of both that is matched (authors)"), "score_geometric");
  cappedGeometric_ =
      add(2, 1, tr("Capped G"), tr("The same, matched only where they lie within the tolerance"),
          "score_capped_geometric");
  structural_ =
      add(3, 1, tr("Structural T"),
          tr("Share of the matches whose bearers are matched, too (authors)"), "score_structural");
  structuralOfAll_ =
      add(4, 1, tr("T over all segments"),
          tr("The same as a share of all segments of the reference"), "score_structural_all");
  types_ = add(5, 1, tr("Edge types, κ"),
               tr("Agreement on what continues an axis and what branches, beyond chance (Cohen)"),
               "score_types");
  work_ = add(6, 1, tr("Work by hand"), tr("From the history of the plant"), "score_work");
  grid->setRowStretch(7, 1);
  setObjectName("evaluation_scores");
  setAccessibleName(tr("Scores"));
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setWidget(scores_);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  fit();
}

QLabel* EvaluationScores::addScore(QGridLayout& grid, int row, int column, const QString& text,
                                   const QString& help, const char* name) {
  auto* label = new QLabel(text);
  label->setToolTip(help);
  grid.addWidget(label, row, 2 * column);
  auto* value = makeLabel(name, "value");
  value->setToolTip(help);
  value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  value->setTextInteractionFlags(Qt::TextSelectableByMouse);
  value->setAccessibleName(text);
  grid.addWidget(value, row, 2 * column + 1);
  return value;
}

void EvaluationScores::show(const Evaluation& evaluation) {
  const Comparison& comparison = evaluation.comparison;
  const auto share = [](QLabel* label, double value) { label->setText(shareText(value)); };
  share(f_, evaluation.score.f());
  share(precision_, evaluation.score.precision);
  share(recall_, evaluation.score.recall);
  share(tips_, comparison.tips.f());
  share(branchings_, comparison.branchings.f());
  share(mapping_, comparison.authors.mapping);
  share(geometric_, comparison.authors.geometric);
  share(cappedGeometric_, evaluation.comparison.capped.front().geometric);
  share(structural_, comparison.authors.structural);
  share(structuralOfAll_, evaluation.comparison.authors.structuralOfAll);
  distances_->setText(
      tr("%1, %2").arg(formatLength(comparison.tolerance.toReference.mean, LengthUnit::unknown, 3),
                       formatLength(comparison.tolerance.toResult.mean, document_.unit(), 3)));
  edits_->setText(comparison.edit ? QString::number(comparison.edit->distance.distance, 'g', 6)
                                  : QStringLiteral("–"));
  share(types_, evaluation.comparison.architecture.types.kappa());
  fit();
}

void EvaluationScores::fit() {
  constexpr int scrollBar = 14;
  scores_->layout()->activate();
  setFixedWidth(std::max(396, scores_->minimumSizeHint().width() + scrollBar));
}

void EvaluationScores::forget() {
  for (QLabel* label :
       {f_, precision_, recall_, tips_, branchings_, mapping_, geometric_, cappedGeometric_,
        structural_, structuralOfAll_, distances_, edits_, types_})
    label->setText(QStringLiteral("–"));
}

void EvaluationScores::setStale(bool isStale) {
  for (QLabel* label : scores_->findChildren<QLabel*>())
    if (label != work_ && !label->objectName().isEmpty())
      setRole(*label, isStale ? "quiet" : "value");
}

void EvaluationScores::showHandWork(const HandWork& work) {
  const std::size_t edits = work.corrections.edits;
  work_->setText(edits == 0 ? tr("none")
                            : tr("%1, %2").arg(edits == 1 ? tr("1 edit")
                                                          : tr("%1 edits").arg(formatCount(edits)),
                                               formatWorkTime(work.time)));
  work_->setToolTip(tr("Since the last reconstruction: %1").arg(describe(work.corrections)));
  fit();
}

} // namespace espalier
