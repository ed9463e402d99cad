#include "ui/panels/evaluation_panel.h"

#include "ui/document/hand_work_text.h"
#include "ui/document/plant_document.h"

#include <QAction>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace espalier {
namespace {

QString shareText(double share) {
  return QString::number(share, 'f', 3);
}

QLabel* makeLabel(const char* name, const char* role) {
  auto* label = new QLabel;
  label->setObjectName(name);
  label->setProperty("role", role);
  return label;
}

void setRole(QWidget& widget, const char* role) {
  widget.setProperty("role", role);
  widget.style()->polish(&widget);
}

} // namespace

EvaluationPanel::EvaluationPanel(const PlantDocument& document, const Parts& parts, QWidget* parent)
    : QWidget(parent), document_(document), content_(new QWidget), empty_(new QWidget) {
  setObjectName("evaluation_panel");
  auto* page = new QVBoxLayout(this);
  page->setContentsMargins(12, 8, 12, 8);

  auto* asking = new QVBoxLayout(empty_);
  auto* hint = makeLabel("evaluation_hint", "quiet");
  hint->setText(tr("Load the structure that the plant is to be compared with"));
  auto* load = new QPushButton(tr("Load Reference…"));
  load->setObjectName("evaluation_load");
  connect(load, &QPushButton::clicked, parts.load, &QAction::trigger);
  asking->addStretch();
  asking->addWidget(hint, 0, Qt::AlignHCenter);
  asking->addWidget(load, 0, Qt::AlignHCenter);
  asking->addStretch();
  page->addWidget(empty_);

  auto* column = new QVBoxLayout(content_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(4);
  column->addWidget(makeHead(parts));
  auto* row = new QHBoxLayout;
  row->setSpacing(12);
  row->addWidget(makeScores());
  row->addWidget(parts.plot, 2);
  row->addWidget(parts.errors, 3);
  column->addLayout(row, 1);
  page->addWidget(content_);
  setReference({});
  showRest({});
}

QWidget* EvaluationPanel::makeHead(const Parts& parts) {
  auto* head = new QWidget;
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(8);
  title_ = makeLabel("evaluation_title", "title");
  row->addWidget(title_);
  laid_ = new QCheckBox(tr("Lay on the plant"));
  laid_->setObjectName("evaluation_laid");
  laid_->setToolTip(
      tr("Moves the reference to where it fits the plant best; off: both are compared "
         "where their files say"));
  connect(laid_, &QCheckBox::toggled, this, &EvaluationPanel::laidChosen);
  row->addWidget(laid_);
  shift_ = makeLabel("evaluation_shift", "quiet");
  row->addWidget(shift_);
  row->addStretch();
  state_ = makeLabel("evaluation_state", "quiet");
  row->addWidget(state_);
  progress_ = new QProgressBar;
  progress_->setObjectName("evaluation_progress");
  progress_->setTextVisible(false);
  progress_->setRange(0, 1000);
  progress_->setFixedSize(80, 6);
  row->addWidget(progress_);
  cancel_ = new QPushButton(tr("Cancel"));
  cancel_->setObjectName("evaluation_cancel");
  connect(cancel_, &QPushButton::clicked, this, &EvaluationPanel::cancelRequested);
  row->addWidget(cancel_);
  compare_ = new QPushButton(tr("Compare"));
  compare_->setObjectName("evaluation_compare");
  connect(compare_, &QPushButton::clicked, this, &EvaluationPanel::compareRequested);
  row->addWidget(compare_);
  auto* color = new QToolButton;
  color->setDefaultAction(parts.color);
  color->setProperty("role", "panel");
  color->setObjectName("evaluation_color");
  color->setText(tr("Color")); // shorter than that of the menu
  connect(parts.color, &QAction::changed, color, [color] { color->setText(tr("Color")); });
  row->addWidget(color);
  auto* report = new QToolButton;
  report->setDefaultAction(parts.report);
  report->setProperty("role", "panel");
  report->setObjectName("evaluation_report");
  report->setText(tr("Report…"));
  connect(parts.report, &QAction::changed, report, [report] { report->setText(tr("Report…")); });
  row->addWidget(report);
  row->addWidget(new QLabel(tr("Tolerance")));
  tolerance_ = new QDoubleSpinBox;
  tolerance_->setObjectName("evaluation_tolerance");
  tolerance_->setAccessibleName(tr("Tolerance"));
  tolerance_->setToolTip(tr("What lies this near to the other skeleton is called matched"));
  tolerance_->setKeyboardTracking(false);
  tolerance_->setButtonSymbols(QAbstractSpinBox::NoButtons);
  tolerance_->setFixedWidth(88);
  connect(tolerance_, &QDoubleSpinBox::valueChanged, this, &EvaluationPanel::toleranceChosen);
  row->addWidget(tolerance_);
  return head;
}

QLabel* EvaluationPanel::addScore(QGridLayout& grid, int row, int column, const QString& text,
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

QWidget* EvaluationPanel::makeScores() {
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
  auto* area = scoresArea_ = new QScrollArea;
  area->setObjectName("evaluation_scores");
  area->setAccessibleName(tr("Scores"));
  area->setFrameShape(QFrame::NoFrame);
  area->setWidgetResizable(true);
  area->setWidget(scores_);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  fitScores();
  return area;
}

void EvaluationPanel::setReference(const QString& name) {
  title_->setText(tr("Compared with %1").arg(name));
  empty_->setVisible(name.isEmpty());
  content_->setVisible(!name.isEmpty());
  if (name.isEmpty()) forgetScores();
}

void EvaluationPanel::showScores(const Evaluation& evaluation) {
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
                       length(comparison.tolerance.toResult.mean)));
  edits_->setText(comparison.edit ? QString::number(comparison.edit->distance.distance, 'g', 6)
                                  : QStringLiteral("–"));
  share(types_, evaluation.comparison.architecture.types.kappa());
  setTolerance(evaluation.tolerance);
  refreshShift(evaluation);
  fitScores();
}

void EvaluationPanel::fitScores() {
  constexpr int scrollBar = 14;
  scores_->layout()->activate();
  scoresArea_->setFixedWidth(std::max(396, scores_->minimumSizeHint().width() + scrollBar));
}

void EvaluationPanel::refreshShift(const Evaluation& evaluation) {
  QStringList notes;
  for (const std::string& warning : evaluation.comparison.warnings)
    notes.append(QString::fromStdString(warning));
  const bool isWarning = (laid_->isChecked() && evaluation.isShiftLarge) || !notes.isEmpty();
  QString text;
  if (laid_->isChecked())
    text = evaluation.isShiftLarge ? tr("⚠ it lay %1 off").arg(length(evaluation.shift.norm()))
                                   : tr("moved by %1").arg(length(evaluation.shift.norm()));
  const Eigen::Vector3d& shift = evaluation.shift;
  QString whole;
  if (laid_->isChecked())
    whole = tr("The reference is moved by (%1, %2, %3) to lie on the plant. Where only one of them "
               "was moved, the two files have different frames.")
                .arg(length(shift.x()), length(shift.y()), length(shift.z()));
  if (!notes.isEmpty()) {
    text += (text.isEmpty() ? QString() : QStringLiteral("  ")) + tr("⚠ doubtful");
    whole += (whole.isEmpty() ? QString() : QStringLiteral("\n")) + notes.join('\n');
  }
  shift_->setText(text);
  shift_->setToolTip(whole);
  setRole(*shift_, isWarning ? "warning" : "quiet");
}

void EvaluationPanel::forgetScores() {
  for (QLabel* label :
       {f_, precision_, recall_, tips_, branchings_, mapping_, geometric_, cappedGeometric_,
        structural_, structuralOfAll_, distances_, edits_, types_})
    label->setText(QStringLiteral("–"));
  shift_->clear();
}

void EvaluationPanel::setStale(bool isStale) {
  for (QLabel* label : scores_->findChildren<QLabel*>())
    if (label != work_ && !label->objectName().isEmpty())
      setRole(*label, isStale ? "quiet" : "value");
}

void EvaluationPanel::showHandWork(const HandWork& work) {
  const std::size_t edits = work.corrections.edits;
  work_->setText(edits == 0 ? tr("none")
                            : tr("%1, %2").arg(edits == 1 ? tr("1 edit")
                                                          : tr("%1 edits").arg(formatCount(edits)),
                                               formatWorkTime(work.time)));
  work_->setToolTip(tr("Since the last reconstruction: %1").arg(describe(work.corrections)));
  fitScores();
}

void EvaluationPanel::showProgress(double fraction) {
  state_->setText(tr("Comparing…"));
  progress_->setValue(static_cast<int>(std::lround(1000 * fraction)));
  progress_->show();
  cancel_->show();
  compare_->hide();
}

void EvaluationPanel::showRest(const QString& text) {
  state_->setText(text);
  progress_->hide();
  cancel_->hide();
  compare_->setVisible(!text.isEmpty());
}

void EvaluationPanel::setTolerance(double tolerance) {
  if (tolerance <= 0) return;
  const QSignalBlocker blocker(tolerance_);
  const QString unit = symbol(document_.unit());
  const double power = std::floor(std::log10(tolerance));
  tolerance_->setSuffix(unit.isEmpty() ? QString() : QChar(0x202f) + unit);
  tolerance_->setDecimals(std::clamp(2 - static_cast<int>(power), 0, 9));
  tolerance_->setRange(tolerance / 1000, 1000 * tolerance);
  tolerance_->setSingleStep(std::pow(10, power));
  tolerance_->setValue(tolerance);
}

void EvaluationPanel::setLaid(bool isLaid) {
  const QSignalBlocker blocker(laid_);
  laid_->setChecked(isLaid);
}

QString EvaluationPanel::length(double value) const {
  return formatLength(value, document_.unit(), 3);
}

} // namespace espalier
