#include "ui/panels/evaluation_panel.h"

#include "ui/document/number_box.h"
#include "ui/document/plant_document.h"
#include "ui/document/shown_message.h"
#include "ui/panels/elided_label.h"
#include "ui/panels/evaluation_scores.h"
#include "ui/panels/label_role.h"

#include <QAction>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {
namespace {

QString angleText(double radians) {
  return QString::number(radians * 180 / std::numbers::pi, 'f', 1) + QStringLiteral("°");
}

} // namespace

EvaluationPanel::EvaluationPanel(const PlantDocument& document, const Parts& parts, QWidget* parent)
    : QWidget(parent), document_(document), content_(new QWidget), empty_(parts.alone),
      scores_(new EvaluationScores(document)) {
  setObjectName("evaluation_panel");
  auto* page = new QVBoxLayout(this);
  page->setContentsMargins(12, 8, 12, 8);

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
  parts.plot->setMinimumWidth(180); // of a screen of 1280, numbers and errors need the rest
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
  title_ = new ElidedLabel;
  title_->setObjectName("evaluation_title");
  title_->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
  setRole(*title_, "title");
  row->addWidget(title_);
  laid_ = new QCheckBox(tr("Lay on the plant"));
  laid_->setObjectName("evaluation_laid");
  laid_->setToolTip(
      tr("Moves the reference to where it fits the plant best; off: both are compared "
         "where their files say"));
  connect(laid_, &QCheckBox::toggled, this, &EvaluationPanel::laidChosen);
  row->addWidget(laid_);
  turns_ = new QCheckBox(tr("Turn it, too"));
  turns_->setObjectName("evaluation_turns");
  turns_->setToolTip(tr("Looks for a turn by any angle about the upright axis, and by some degrees "
                        "about any other, and takes it where it fits clearly better"));
  connect(turns_, &QCheckBox::toggled, this, &EvaluationPanel::turnsChosen);
  connect(laid_, &QCheckBox::toggled, turns_, &QCheckBox::setEnabled);
  row->addWidget(turns_);
  shift_ = new ElidedLabel;
  shift_->setObjectName("evaluation_shift");
  setRole(*shift_, "quiet");
  row->addWidget(shift_, 1);
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
  auto* edits = new QToolButton;
  edits->setText(tr("Edits"));
  edits->setToolTip(tr("What the edit distance counts, and which part stands for which"));
  edits->setProperty("role", "panel");
  edits->setObjectName("evaluation_edits");
  edits->setPopupMode(QToolButton::InstantPopup);
  edits->setMenu(parts.edits);
  row->addWidget(edits);
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
  title_->setText(name);
  title_->setToolTip(tr("Compared with %1").arg(name));
  empty_->setVisible(name.isEmpty());
  content_->setVisible(!name.isEmpty());
  if (name.isEmpty()) forgetScores();
}

void EvaluationPanel::showScores(const Evaluation& evaluation) {
  scores_->show(evaluation);
  setTolerance(evaluation.tolerance);
  refreshPlace(evaluation);
}

void EvaluationPanel::showIntervals(const std::map<std::string, ScoreInterval>& intervals) {
  scores_->showIntervals(intervals);
}

/// What makes the numbers doubtful is read above them; a small shift only is a remark.
void EvaluationPanel::refreshPlace(const Evaluation& evaluation) {
  QStringList lines;
  for (const ShownMessage& warning : evaluation.comparison.warnings)
    lines.append(shownText(warning));
  shift_->clear();
  shift_->setToolTip({});
  warnings_->setToolTip({});
  if (evaluation.registration) {
    const Registration& lay = *evaluation.registration; // of the plant, as in reports
    const QString far = length(lay.shift.norm());
    const bool isTurned = lay.angle() > 0;
    if (isTurned)
      lines.prepend(
          tr("the two files lie %1 apart and are turned by %2: the reference is shown on the plant")
              .arg(far, angleText(lay.angle())));
    else if (evaluation.isShiftLarge)
      lines.prepend(tr("the two files lie %1 apart: the reference is shown on the plant").arg(far));
    else
      shift_->setText(tr("moved by %1").arg(far));
    (shift_->text().isEmpty() ? warnings_ : shift_)->setToolTip(placeTip(lay));
  }
  for (QString& line : lines)
    line.prepend(QStringLiteral("⚠ "));
  warnings_->setText(lines.join('\n'));
  warnings_->setVisible(!lines.isEmpty());
}

QString EvaluationPanel::placeTip(const Registration& lay) const {
  const Eigen::Vector3d& shift = lay.shift;
  QString tip =
      tr("The plant would be moved by (%1, %2, %3) to lie on the reference; here, the reference is "
         "moved to the plant instead. Far apart, the two files have different frames.")
          .arg(length(shift.x()), length(shift.y()), length(shift.z()));
  if (!(lay.angle() > 0)) return tip;
  const Eigen::Vector3d axis = lay.axis();
  const auto text = [](double value) { return QString::number(value, 'f', 3); };
  return tr("The plant would be turned by %1 about (%2, %3, %4) through its middle first. ")
             .arg(angleText(lay.angle()), text(axis.x()), text(axis.y()), text(axis.z())) +
         tip;
}

void EvaluationPanel::forgetScores() {
  scores_->forget();
  shift_->clear();
  warnings_->hide();
}

void EvaluationPanel::setStale(bool isStale) {
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
  turns_->setEnabled(isLaid);
}

void EvaluationPanel::setTurns(bool turns) {
  const QSignalBlocker blocker(turns_);
  turns_->setChecked(turns);
}

void EvaluationPanel::setMovable(bool isMovable) {
  laid_->setVisible(isMovable);
  turns_->setVisible(isMovable);
}

QString EvaluationPanel::length(double value) const {
  return formatLength(value, document_.unit(), 3);
}

} // namespace espalier
