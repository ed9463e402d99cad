#include "ui/panels/evaluation_panel.h"

#include "ui/document/plant_document.h"
#include "ui/panels/evaluation_scores.h"
#include "ui/panels/label_role.h"
#include "ui/panels/number_box.h"

#include <QAction>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace espalier {
EvaluationPanel::EvaluationPanel(const PlantDocument& document, const Parts& parts, QWidget* parent)
    : QWidget(parent), document_(document), content_(new QWidget), empty_(new QWidget),
      scores_(new EvaluationScores(document)) {
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
  warnings_ = makeLabel("evaluation_warnings", "warning");
  warnings_->setWordWrap(true);
  warnings_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  column->addWidget(warnings_);
  auto* row = new QHBoxLayout;
  row->setSpacing(12);
  row->addWidget(scores_);
  row->addWidget(parts.plot, 1);
  row->addWidget(parts.errors, 2);
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
  tolerance_ = new NumberBox;
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

void EvaluationPanel::setReference(const QString& name) {
  title_->setText(tr("Compared with %1").arg(name));
  empty_->setVisible(name.isEmpty());
  content_->setVisible(!name.isEmpty());
  if (name.isEmpty()) forgetScores();
}

void EvaluationPanel::showScores(const Evaluation& evaluation) {
  scores_->show(evaluation);
  setTolerance(evaluation.tolerance);
  refreshShift(evaluation);
  refreshWarnings(evaluation);
}

void EvaluationPanel::refreshShift(const Evaluation& evaluation) {
  shift_->clear();
  shift_->setToolTip({});
  if (!laid_->isChecked()) return;
  const Eigen::Vector3d shift = -evaluation.shift; // of the plant, as reports tell it
  shift_->setText(evaluation.isShiftLarge ? tr("⚠ they were %1 apart").arg(length(shift.norm()))
                                          : tr("moved by %1").arg(length(shift.norm())));
  shift_->setToolTip(
      tr("The plant would be moved by (%1, %2, %3) to lie on the reference; here, the reference is "
         "moved to the plant instead. Far apart, the two files have different frames.")
          .arg(length(shift.x()), length(shift.y()), length(shift.z())));
  setRole(*shift_, evaluation.isShiftLarge ? "warning" : "quiet");
}

/// What makes the numbers doubtful is read above them.
void EvaluationPanel::refreshWarnings(const Evaluation& evaluation) {
  QStringList lines;
  for (const std::string& warning : evaluation.comparison.warnings)
    lines.append(QStringLiteral("⚠ ") + QString::fromStdString(warning));
  warnings_->setText(lines.join('\n'));
  warnings_->setVisible(!lines.isEmpty());
}

void EvaluationPanel::forgetScores() {
  scores_->forget();
  shift_->clear();
  warnings_->hide();
}

void EvaluationPanel::setStale(bool isStale) {
  if (isStale) setRole(*shift_, "quiet");
  scores_->setStale(isStale);
}

void EvaluationPanel::showHandWork(const HandWork& work) {
  scores_->showHandWork(work);
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
